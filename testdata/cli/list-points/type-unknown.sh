list-points --type middle "$DATA/good/grid/square.grid"
