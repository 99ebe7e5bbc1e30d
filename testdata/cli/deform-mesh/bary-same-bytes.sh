mkgrid --rect 0,0,4,4 --cells 4x4 >r; decles-edit -e 'rotate @2,2 about 2 2 by 20 reach 9' r >g
awk 'BEGIN { for (i = 0; i <= 40; i++) print "v", i "e-1", (i * 7 % 41) "e-1", i }' >m.obj
bary m.obj r >b
deform-mesh m.obj g >one
deform-mesh --bary b m.obj g | cmp - one
bary m.obj g | deform-mesh --bary - m.obj g | cmp - one
deform-mesh --bary b --plane xy m.obj <g | cmp - one
