mkgrid --triangulation "$DATA/good/node/square.node" --degree 1
