mkgrid --rect 0,0,1,1 --cells 1x1 --degree 1 >a.grid
mix-grid -o out.grid -1 a.grid && cat out.grid
