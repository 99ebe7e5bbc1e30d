mkgrid --polygon "$DATA/good/poly/hole.poly"
