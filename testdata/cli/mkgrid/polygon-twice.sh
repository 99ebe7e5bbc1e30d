# The same bytes, wherever its memory lies.
mkgrid --polygon "$DATA/shapes2d/poly2tri/dude.dat" -o a.grid
mkgrid --polygon "$DATA/shapes2d/poly2tri/dude.dat" -o b.grid
cmp a.grid b.grid && cksum <a.grid
