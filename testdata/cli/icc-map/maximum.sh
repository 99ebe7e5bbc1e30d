# k and lambda mean nothing where t is 0
printf "0 0 0\n3 0.5 0\n99 -7 0\n" | icc-map --from-coords $DATA/examples/square.xy $DATA/examples/square.xy
echo "0.5 0.5" | icc-map --coords $DATA/examples/square.xy
