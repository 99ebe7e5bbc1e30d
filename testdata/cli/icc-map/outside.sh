printf '0.5 0.5\n# a comment\n2 0.5\n3 3\n' >p.xy
icc-map "$DATA/examples/square.xy" "$DATA/examples/quad.xy" p.xy
