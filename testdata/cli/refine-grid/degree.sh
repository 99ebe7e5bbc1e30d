mkgrid --rect 0,0,1,1 --cells 1x1 --degree 2 --depth 0,1 | refine-grid --degree 3
