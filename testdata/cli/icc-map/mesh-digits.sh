# three digits, of numbers from 0 to 694: triangles that this would turn over give way
icc-map --mesh 8 --verbose --digits 3 "$DATA/shapes2d/glyph_pairs_cantarell/upper_L_regular.dat" \
    "$DATA/shapes2d/glyph_pairs_cantarell/upper_L_thin.dat" >L.obj
grep -c '^v ' L.obj
awk '$1 == "v" && length($2) > 5' L.obj
