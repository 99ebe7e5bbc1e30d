mkgrid --rect 0,0,4,4 --cells 1x1 >g
printf '1 1 1\nHOLE\n' >p.xyz
deform-mesh p.xyz g
