# the target is triangulated, and mapped to the source
icc-map --mesh 0.2 --inverse --digits 5 "$DATA/examples/square.xy" "$DATA/examples/quad.xy"
