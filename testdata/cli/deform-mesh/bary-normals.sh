mkgrid --rect 0,0,1,1 --cells 1x1 --degree 5 >g
decles-edit -e 'move 2 3 by 0.5 0 reach 9' g >h
bary $DATA/good/obj/square.obj g >b
deform-mesh $DATA/good/obj/square.obj h >one
deform-mesh --bary b $DATA/good/obj/square.obj h | cmp - one
