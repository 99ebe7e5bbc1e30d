echo nothing.xy >list
icc-map --poses list "$DATA/examples/cage.xy" "$DATA/examples/outline.xy"
