icc-map --match angle "$DATA/examples/L.xy" "$DATA/examples/square.xy" p
