echo "0.25 0.5" | icc-map --cell 1e-9 $DATA/examples/square.xy $DATA/examples/quad.xy
