mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 1 --degree 1 >g
printf 'v 1 2 3\n' >m.xy
bary --format obj m.xy g
bary m.xy g
