mkgrid --rect 0,0,1,1 --cells 1x1 --degree 11 | convert-grid --to msh
