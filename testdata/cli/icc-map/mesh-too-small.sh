icc-map --mesh 1e-7 "$DATA/examples/square.xy" "$DATA/examples/quad.xy"
