# Places of the model before it was deformed: the same bytes, from a pipe too.
mkgrid --rect 0,0,4,4 --cells 4x4 >r; decles-edit -e 'rotate @2,2 about 2 2 by 20 reach 9' r >g
awk 'BEGIN { for (i = 0; i <= 40; i++) print "v", i "e-1", (i * 7 % 41) "e-1", i }' >m.obj
bary m.obj r >b
deform-mesh m.obj g >bent.obj
deform-mesh --inverse bent.obj g >one
deform-mesh --inverse --bary b bent.obj g | cmp - one
bary m.obj g | deform-mesh --inverse --bary - bent.obj g | cmp - one
