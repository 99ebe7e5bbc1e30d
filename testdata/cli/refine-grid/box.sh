mkgrid --rect 0,0,4,4 --cells 4x4 --degree 1 | refine-grid --times 2 --box 0,0,0.5,0.5 --digits 6
