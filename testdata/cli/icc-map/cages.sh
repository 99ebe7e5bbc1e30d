# Each refusal with its witness.
E=$DATA/examples
printf '0 0\n1 1\n1 0\n0 1\n' >bow.xy
printf '0 0\n1 0\n1 0\n0 1\n' >twice.xy
printf '0 0\n0 1\n1 1\n1 0\n' >clockwise.xy
printf '0 0\n1 0\n' >two.xy
printf '0 0\n1 0\n2 0\n3 0\n' >flat.xy
printf '0 0\n9 0\n9 9\nHOLE\n1 1\n2 1\n2 2\n' >hole.xy
printf '0 0\n2 0\n1 0\n0 1\n' >touch.xy
for target in "$E/L.xy" bow.xy twice.xy clockwise.xy two.xy flat.xy hole.xy touch.xy nothing.xy; do
    icc-map "$E/square.xy" $target "$E/points.xy"
    echo "status $?"
done
