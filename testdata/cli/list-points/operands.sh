# A last operand without the form of POINTS is the grid; ./17 is a file.
cp "$DATA/good/grid/square.grid" 17
list-points v:0 ./17
list-points 17 <17 | cut -d ' ' -f 1-3
list-points 17.grid v:0
