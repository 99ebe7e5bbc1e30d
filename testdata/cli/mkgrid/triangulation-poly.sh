mkgrid --triangulation "$DATA/good/poly/hole.poly" --degree 1
