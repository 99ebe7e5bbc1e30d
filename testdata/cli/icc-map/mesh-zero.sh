icc-map --mesh 0 "$DATA/examples/square.xy" "$DATA/examples/quad.xy"
