mkgrid --rect 0,0,2,1 --cells 2x1 --degree 2 | refine-grid
