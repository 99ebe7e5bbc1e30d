# 16 cells along the longer side
mkgrid --image "$DATA/images/worm.png" --degree 1 | grep -E '^(vertices|triangles)'
