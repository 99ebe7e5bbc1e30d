# Control points so large that the sum overflows; (2,0) is an edge's.
mkgrid --rect 0,0,4,4 --cells 1x1 --degree 2 --lattice 1 | sed 's/^2 0$/1.7e308 0/' >huge.grid
printf 'v 1 4 0\nv 3.9 0 0\n' | deform-mesh - huge.grid
