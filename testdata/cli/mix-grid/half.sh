mkgrid --rect 0,0,1,1 --cells 1x1 --degree 1 >a.grid
sed "s/^0 1$/0 3/" a.grid >b.grid
mix-grid 0.5 a.grid 0.5 b.grid
