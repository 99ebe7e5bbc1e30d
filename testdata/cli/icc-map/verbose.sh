icc-map --verbose --digits 3 "$DATA/examples/square.xy" "$DATA/examples/quad.xy" "$DATA/examples/points.xy"
