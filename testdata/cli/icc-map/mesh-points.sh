# it maps no points
icc-map --mesh 0.2 "$DATA/examples/square.xy" "$DATA/examples/quad.xy" "$DATA/examples/points.xy"
