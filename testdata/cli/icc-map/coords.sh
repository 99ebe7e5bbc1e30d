# Bound once, posed twice; what is outside is kept, and put back.
printf '0.5 0.5 a # one\n\n0.25 0.5\n7 8 far\n1 0.25\n' >p.xy
icc-map --coords --outside keep "$DATA/examples/square.xy" p.xy | tee bound
icc-map --from-coords "$DATA/examples/square.xy" "$DATA/examples/quad.xy" bound
printf '2 0.3 0\n0 0 0\n' | icc-map --from-coords "$DATA/examples/square.xy" "$DATA/examples/square.xy"
