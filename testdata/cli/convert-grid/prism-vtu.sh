convert-grid --to vtu $DATA/good/grid/prism.grid
