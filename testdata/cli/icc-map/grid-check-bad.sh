printf "0 0\n2 0\n2 1\n1 1\n1 2\n0 2\n" >L.xy
printf "0 0\n2 0\n2 1\n2 2\n1 2\n0 2\n" >square.xy
printf "0 0\n2 0.9\n4 0\n3.1 2\n4 4\n2 3.1\n0 4\n0.9 2\n" >star.xy
icc-map --method grid --resolution-check off --coords star.xy
