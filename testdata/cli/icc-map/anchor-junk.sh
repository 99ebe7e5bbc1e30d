icc-map --match arclength --anchor 1:2: "$DATA/examples/L.xy" "$DATA/examples/square.xy" p
