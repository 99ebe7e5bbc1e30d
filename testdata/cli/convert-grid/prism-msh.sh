convert-grid --to msh $DATA/good/grid/prism.grid
