convert-grid --to vtu --steps 4 $DATA/good/grid/square.grid
