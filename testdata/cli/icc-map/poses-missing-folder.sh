ln -s "$DATA/examples/poses/frame193.xy" .
echo frame193.xy >list
icc-map --poses list --out-dir nowhere "$DATA/examples/cage.xy" "$DATA/examples/outline.xy"
