mkgrid --rect 0,0,1,1 --cells 1x1 --degree 1 --depth 0,1 >a.grid
sed "s/^0 1 0 1$/0 3 0 2/" a.grid >b.grid
mix-grid -1 a.grid 2 b.grid
