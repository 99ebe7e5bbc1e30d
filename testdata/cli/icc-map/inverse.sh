# There and back within rounding.
icc-map "$DATA/examples/square.xy" "$DATA/examples/quad.xy" "$DATA/examples/points.xy" |
    icc-map --inverse --digits 12 "$DATA/examples/square.xy" "$DATA/examples/quad.xy"
