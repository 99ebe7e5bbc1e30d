list-points 3 box:1,2 <"$DATA/good/grid/square.grid"
