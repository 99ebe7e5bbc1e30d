convert-grid --to vtu $DATA/good/grid/square.grid
