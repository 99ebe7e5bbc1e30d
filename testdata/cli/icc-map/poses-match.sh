icc-map --poses list --out-dir . --match arclength "$DATA/examples/cage.xy" p
