# one digit, and the bars of the letter fall together
icc-map --mesh 2000 --digits 1 "$DATA/shapes2d/glyph_pairs_cantarell/upper_E_extrabold.dat" \
    "$DATA/shapes2d/glyph_pairs_cantarell/upper_E_thin.dat"
