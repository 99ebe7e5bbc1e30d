mkgrid --rect 0,0,4,4 --cells 4x4 >r; decles-edit -e 'rotate @2,2 about 2 2 by 20 reach 9' r >g
echo 'v 1 1 1' >m.obj
echo 'v 1 1 1.5' >n.obj
bary m.obj r >b
deform-mesh --bary b n.obj g
