mkgrid --rect 0,0,4,4 --cells 4x4 >g
mkgrid --rect 0,0,4,4 --cells 4x3 >o
echo 'v 1 1 1' >m.obj
bary m.obj o >b
deform-mesh --inverse --bary b m.obj g
