check-grid "$DATA/good/grid/square.grid"
