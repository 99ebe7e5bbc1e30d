mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 1 >g
printf '# three\n\n1 1\n5 1 far\n' >p.xy
bary p.xy g
