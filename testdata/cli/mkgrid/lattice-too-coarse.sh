mkgrid --rect 0,0,1,1 --cells 9x9 --lattice 0.125
