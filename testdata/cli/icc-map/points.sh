icc-map --points 2000 --digits 6 "$DATA/examples/square.xy" "$DATA/examples/quad.xy" "$DATA/examples/points.xy"
icc-map --cell 0.05 --digits 6 "$DATA/examples/square.xy" "$DATA/examples/quad.xy" "$DATA/examples/points.xy"
