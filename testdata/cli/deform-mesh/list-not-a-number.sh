mkgrid --rect 0,0,4,4 --cells 1x1 >g
printf '1 1\n2 nan\n' >p.xy
deform-mesh p.xy g
