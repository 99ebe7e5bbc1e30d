mkgrid --rect -1e308,0,1e308,1 --cells 1x1
