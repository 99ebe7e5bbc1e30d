mkgrid --rect -1,-1,1,1 --cells 2x1 --pattern cross --degree 2
