cp "$DATA/good/node/square.node" "$DATA/good/ele/square.ele" .
mkgrid --triangulation square.ele --degree 1
