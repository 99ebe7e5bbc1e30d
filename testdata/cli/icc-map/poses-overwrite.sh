# the folder of the poses themselves
cp "$DATA/examples/poses/frame193.xy" .
echo frame193.xy >list
icc-map --poses list --out-dir . "$DATA/examples/cage.xy" "$DATA/examples/outline.xy"
status=$?
cmp frame193.xy "$DATA/examples/poses/frame193.xy"
exit $status
