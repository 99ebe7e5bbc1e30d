mkgrid --rect 0,0,1,1
