# the message says what to do
cp "$DATA/examples/L.xy" "$DATA/examples/square.xy" .
icc-map L.xy square.xy "$DATA/examples/points.xy"
