# there is no such vertex
cp "$DATA/examples/L.xy" "$DATA/examples/square.xy" .
icc-map --match arclength --anchor 0:4 L.xy square.xy p
