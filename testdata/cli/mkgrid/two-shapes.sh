mkgrid --rect 0,0,1,1 --model x.obj --cells 3x3
