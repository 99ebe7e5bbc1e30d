mkgrid --rect 0,0,1,1 --cells 0x1
