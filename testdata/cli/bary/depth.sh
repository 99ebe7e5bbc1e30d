mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 1 --depth -2,6 --degree 1 >g
printf 'v 1 1 -2\nv 1 1 0\nv 3 1 6\nf 1 2 3\n' >m.obj
bary m.obj g
