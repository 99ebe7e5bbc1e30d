list-points 3 60-66 "$DATA/good/grid/square.grid"
