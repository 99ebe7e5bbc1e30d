cp "$DATA/good/ele/square.ele" .
mkgrid --triangulation square.ele
