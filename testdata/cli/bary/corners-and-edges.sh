# lowest triangles win: 0 1 4 | 0 4 3 | 1 2 5 | ...
mkgrid --rect 0,0,2,2 --cells 2x2 --lattice 1 --degree 1 >g
printf '0 0\n1 0\n1 1\n2 2\n0.5 0.5\n1 0.25\n1.5 1\n0.25 2\n0.1 0.7\n' >p.xy
bary p.xy g
