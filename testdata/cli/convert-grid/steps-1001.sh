convert-grid --to obj --steps 1001 $DATA/good/grid/square.grid
