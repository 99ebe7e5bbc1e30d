# one worm in three postures; each is what a call for that posture alone gives
mkdir bent
ls "$DATA"/examples/poses/*.xy | icc-map --poses - --out-dir bent --digits 6 \
    "$DATA/examples/cage.xy" "$DATA/examples/outline.xy"
for pose in frame193 frame303 frame449; do
    icc-map --digits 6 "$DATA/examples/cage.xy" "$DATA/examples/poses/$pose.xy" \
        "$DATA/examples/outline.xy" | cmp - bent/$pose.xy
    head -n 2 bent/$pose.xy
done
ls bent
