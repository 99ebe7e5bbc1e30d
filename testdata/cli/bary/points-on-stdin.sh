mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 1 --degree 1 >g
printf '1 1\n3 1 b\n' | bary --format xy - g
