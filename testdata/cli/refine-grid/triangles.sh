mkgrid --rect 0,0,4,1 --cells 4x1 --degree 1 | refine-grid --triangles 0,2-3
