mkgrid --rect 0,0,10,10 --cells 100x50 --degree 1 | convert-grid --to obj --steps 1000
