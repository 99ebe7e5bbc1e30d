mkgrid --rect 0,0,1,1 --cells 1x1 >a.grid
mkgrid --rect 0,0,1,1 --cells 2x1 >b.grid
mix-grid 1 a.grid 1 b.grid
