# three vertices in a line, and a cage that turns by them
printf "0 0\n0.5 0\n1 0\n1 1\n0 1\n" >s.xy
printf "0 0\n0.5 0.4\n1 0\n1 1\n0 1\n" >t.xy
printf "0.25 0\n0.5 0\n0.75 0\n0.5 0.1\n" | icc-map --digits 6 s.xy t.xy
