mkgrid --rect 0,0,1,1 --cells 1x1 --degree 1 --depth -2.5,1e3 --plane zy
