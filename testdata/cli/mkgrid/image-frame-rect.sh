mkgrid --rect 0,0,1,1 --cells 1x1 --frame 0,0,1,1
