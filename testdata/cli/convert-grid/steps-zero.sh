convert-grid --to obj --steps 0 $DATA/good/grid/square.grid
