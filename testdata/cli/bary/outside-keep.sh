mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 1 --depth -2,6 --degree 1 >g
printf 'v 1 1 0\nv 5 1 0.1\nv 1 1 7\n' >m.obj
bary --outside keep m.obj g
