# a failure leaves the file of -o as it was
echo old >result
echo "2 2" | icc-map -o result "$DATA"/examples/square.xy "$DATA"/examples/quad.xy
cat result
