convert-grid --to msh $DATA/good/grid/square.grid
