mkgrid --rect 0,0,4,4 --cells 4x4 >r; decles-edit -e 'rotate @2,2 about 2 2 by 20 reach 9' r >g
printf 'v 1 1 1\nv 9 1 1\n' >m.obj
bary --outside keep m.obj r >b
deform-mesh --bary b --outside keep m.obj g
deform-mesh --bary b m.obj g
