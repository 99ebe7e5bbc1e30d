# the model's z and y are the grid's x and y, its x is the depth
mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 1 --depth -2,6 --degree 1 | sed 's/^degree 1/&\nplane zy/' >g
printf '5 1 3\n' >p.xyz
bary p.xyz g
