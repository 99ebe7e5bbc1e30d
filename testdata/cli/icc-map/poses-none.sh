# all or nothing: the second pose has other vertices
mkdir bent
cp "$DATA/examples/cage.xy" "$DATA/examples/L.xy" "$DATA/examples/poses/frame193.xy" .
printf 'frame193.xy\nL.xy\n' >list
icc-map --poses list --out-dir bent cage.xy "$DATA/examples/outline.xy"
status=$?
ls bent
exit $status
