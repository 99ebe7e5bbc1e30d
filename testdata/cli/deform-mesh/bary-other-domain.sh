mkgrid --rect 0,0,4,4 --cells 4x4 >r; decles-edit -e 'rotate @2,2 about 2 2 by 20 reach 9' r >g
mkgrid --rect 0,0,4,4 --cells 4x3 >o
echo 'v 1 1 1' >m.obj
bary m.obj o >b
deform-mesh --bary b m.obj g
