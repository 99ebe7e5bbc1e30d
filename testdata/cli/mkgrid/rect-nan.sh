mkgrid --rect 0,0,nan,1 --cells 1x1
