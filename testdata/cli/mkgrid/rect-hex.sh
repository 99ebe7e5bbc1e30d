mkgrid --rect 0,0,30,26 --cells 2x2 --pattern hex --degree 1
