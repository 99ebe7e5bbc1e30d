mkgrid --rect 0,0,8,8 --cells 8x8 --lattice 1e-6
