mkgrid --rect 0,0,1 --cells 1x1
