# the wrong way round
icc-map --match arclength --anchor 0:0 --anchor 1:3 --anchor 2:2 \
    "$DATA/examples/L.xy" "$DATA/examples/square.xy" p
