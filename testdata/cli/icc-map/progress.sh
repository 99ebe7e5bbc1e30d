icc-map --progress $DATA/examples/square.xy $DATA/examples/square.xy $DATA/examples/points.xy | cmp - $DATA/examples/points.xy
