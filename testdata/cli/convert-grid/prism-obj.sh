convert-grid --to obj $DATA/good/grid/prism.grid
