printf "0 0\n2 0\n2 1\n1 1\n1 2\n0 2\n" >L.xy
printf "0 0\n2 0\n2 1\n2 2\n1 2\n0 2\n" >square.xy
printf "0.5 0.5 first # kept\n1.7 0.3\n0.2 1.9\n2 0.5\n0 0\n" >points.xy
icc-map --method grid --maximum 0.5,1.5,1.5,1.5 --points 100 --digits 9 L.xy square.xy points.xy
