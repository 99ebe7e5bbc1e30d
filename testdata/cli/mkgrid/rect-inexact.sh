# corners that are no multiples of the step are rounded to it; cells differ by a step at most
mkgrid --rect 0.1,0.1,0.8,0.4 --cells 3x1 --degree 1 --lattice-bits 6
