printf "0 0\n2 0\n2 1\n1 1\n1 2\n0 2\n" >L.xy
printf "0 0\n2 0\n2 1\n2 2\n1 2\n0 2\n" >square.xy
icc-map --points 3 --digits 6 --show grid L.xy
