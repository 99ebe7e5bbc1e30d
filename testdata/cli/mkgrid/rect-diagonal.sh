mkgrid --rect 0,0,3,2 --cells 3x2 --degree 1
