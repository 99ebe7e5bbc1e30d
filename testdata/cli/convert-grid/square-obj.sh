convert-grid --to obj $DATA/good/grid/square.grid
