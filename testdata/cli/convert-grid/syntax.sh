sed 's/^degree.*/degree five/' $DATA/good/grid/square.grid | convert-grid --to msh
