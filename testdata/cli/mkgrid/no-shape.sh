mkgrid --cells 3x3
