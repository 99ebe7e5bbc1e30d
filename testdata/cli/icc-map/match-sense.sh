# clockwise and counter-clockwise
cp "$DATA/examples/L.xy" .
printf '0 0\n0 1\n1 1\n1 0\n' >clockwise.xy
echo 1 1 | icc-map --match arclength L.xy clockwise.xy
