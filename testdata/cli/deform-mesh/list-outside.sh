mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 1 | decles-edit -e 'move all by 1 0.5' >g
printf '1 1\n9 1\n' >p.xy
deform-mesh --outside keep --jacobian p.xy g
deform-mesh p.xy g
