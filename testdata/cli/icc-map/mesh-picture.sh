# the first command of the manual
icc-map --match arclength --mesh 0.01 "$DATA/examples/L.xy" "$DATA/examples/square.xy" |
    render-checker --mark-folds -o L.png
