convert-grid --to json $DATA/good/grid/square.grid
