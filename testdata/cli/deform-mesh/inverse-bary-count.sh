mkgrid --rect 0,0,4,4 --cells 4x4 >g
printf 'v 1 1 1\n' >m.obj
printf 'v 1 1 1\nv 2 2 2\n' >more.obj
bary m.obj g | deform-mesh --inverse --bary - more.obj g
