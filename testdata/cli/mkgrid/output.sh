echo old >x.grid
mkgrid --rect 0,0,1,1 --cells 1x1 --degree 1 -o x.grid
mkgrid --rect 0,0,1,1 --cells 9x9 --lattice 0.5 -o x.grid
head -n 2 x.grid
ls
