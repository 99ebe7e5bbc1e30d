# A cage given backwards, or from another vertex on: sides are numbered as they were given.
E=$DATA/examples
tac "$E/square.xy" >s.xy
(tail -n 2 "$E/square.xy"; head -n 2 "$E/square.xy") >a.xy
for cage in "$E/square.xy" s.xy a.xy; do
    printf '0.5 0\n1 0.25\n0 0\n0.5 0.25\n' | icc-map --coords --digits 9 "$cage"
done
