mkgrid --rect 0,0,4,4 --cells 4x4 | decles-edit -e 'move v^2,2 by 1.5 0' >g
echo 2 2 >p.xy
deform-mesh --inverse p.xy g
