printf "0 0\n2 0\n2 1\n1 1\n1 2\n0 2\n" >L.xy
printf "0 0\n2 0\n2 1\n2 2\n1 2\n0 2\n" >square.xy
printf "0 0.5 1\n0 0.5 0.5\n3 0.25 0\n" >coords
icc-map --method grid --points 100 --digits 9 --from-coords L.xy square.xy coords
