# the second file is not there: nothing is written
ln -s "$DATA/examples/poses/frame193.xy" .
mkdir bent
printf 'frame193.xy\nnowhere.xy\n' >list
icc-map --poses list --out-dir bent "$DATA/examples/cage.xy" "$DATA/examples/outline.xy"
status=$?
ls bent
exit $status
