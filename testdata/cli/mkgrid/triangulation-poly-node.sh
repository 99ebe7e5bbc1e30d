cp "$DATA/good/node/square.node" q.node
printf '%s\n' '0 2 0 0' '4 0' '1 1 2' '2 2 3' '3 3 4' '4 4 1' '0' >q.poly
mkgrid --triangulation q.poly --degree 1
