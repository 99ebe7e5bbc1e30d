convert-grid --to ply $DATA/good/grid/square.grid
