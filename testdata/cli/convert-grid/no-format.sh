convert-grid -o a.ply $DATA/good/grid/square.grid
