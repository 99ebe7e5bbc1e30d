convert-grid --to json $DATA/good/grid/prism.grid
