# Another first vertex, both cages clockwise: the same bytes.
E=$DATA/examples
(tail -n 1 "$E/square.xy"; head -n 3 "$E/square.xy") >s.xy
(tail -n 1 "$E/quad.xy"; head -n 3 "$E/quad.xy") >q.xy
icc-map "$E/square.xy" "$E/quad.xy" "$E/points.xy" >a
icc-map s.xy q.xy "$E/points.xy" >b
tac "$E/square.xy" >s.xy
tac "$E/quad.xy" >q.xy
icc-map s.xy q.xy "$E/points.xy" >c
cmp a b && cmp a c && echo same
icc-map "$E/square.xy" "$E/square.xy" "$E/points.xy" | cmp - "$E/points.xy" && echo identity
