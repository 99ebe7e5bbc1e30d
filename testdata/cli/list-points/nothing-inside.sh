printf '5 5\n6 5\n6 6\n' >far.xy
list-points inside:far.xy "$DATA/good/grid/square.grid"
