# bound once for all: coordinates, then as many poses as there are
mkdir bent
ls "$DATA"/examples/poses/*.xy >list
icc-map --coords "$DATA/examples/cage.xy" "$DATA/examples/outline.xy" |
    icc-map --poses list --out-dir bent --from-coords --digits 6 "$DATA/examples/cage.xy"
head -n 2 bent/*
