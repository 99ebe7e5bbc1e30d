# a thin figure that becomes fat: a sample will not do
icc-map --mesh 100 --verbose "$DATA/shapes2d/glyph_pairs_cantarell/digit_5_thin.dat" \
    "$DATA/shapes2d/glyph_pairs_cantarell/digit_5_extrabold.dat" -o 5.obj
grep -c '^f' 5.obj
