icc-map --mesh 0.2 --model m.obj "$DATA/examples/square.xy" "$DATA/examples/quad.xy"
