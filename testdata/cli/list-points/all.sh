list-points "$DATA/good/grid/square.grid"
