# the list and the points cannot both be stdin
icc-map --poses - --out-dir . "$DATA/examples/cage.xy"
