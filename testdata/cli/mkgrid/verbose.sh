mkgrid --rect 0,0,4,3 --cells 4x3 --verbose -o x.grid
cat x.grid | wc -l | tr -d ' '
