echo "2 2" | icc-map --inverse $DATA/examples/square.xy $DATA/examples/quad.xy
