mkgrid --rect 0,0,8,8 --cells 10000x10000 --lattice-bits 24
