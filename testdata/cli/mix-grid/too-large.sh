mkgrid --rect 0,0,1,1 --cells 1x1 >a.grid
mix-grid 1e308 a.grid 1e308 a.grid
