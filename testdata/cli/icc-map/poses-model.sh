# a model gives models
mkdir bent
ls "$DATA"/examples/poses/frame193.xy >list
printf 'v 13 15 7 # inside\nv 13 20 8\nv 12 17 9\nf 1 2 3\n' >m.obj
icc-map --poses list --out-dir bent --model m.obj --digits 6 "$DATA/examples/cage.xy"
ls bent
cat bent/frame193.obj
