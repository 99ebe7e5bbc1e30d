# With depth, the heights of bottom and top follow.
list-points --digits 6 all "$DATA/good/grid/prism.grid"
