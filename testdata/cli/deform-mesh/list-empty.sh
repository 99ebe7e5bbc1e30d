mkgrid --rect 0,0,4,4 --cells 1x1 >g
printf '# none\nHOLE\n' >p.xy
deform-mesh p.xy g
