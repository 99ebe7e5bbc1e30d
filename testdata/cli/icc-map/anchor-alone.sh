icc-map --anchor 0:1 "$DATA/examples/L.xy" "$DATA/examples/square.xy" p
