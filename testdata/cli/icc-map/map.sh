# Points keep their columns and comments; points on sides and corners go linearly.
printf '0.5 0.5 a # one\n\n0.25 0.5\nHOLE\n0 0 corner\n1 0.5\n' >p.xy
icc-map "$DATA/examples/square.xy" "$DATA/examples/quad.xy" p.xy
