# far from 0 the step grows until vertices are doubles
mkgrid --rect 1e16,0,1.0000000000000256e16,256 --cells 2x2 --degree 1
