echo "2 0.5" | icc-map --coords $DATA/examples/square.xy
