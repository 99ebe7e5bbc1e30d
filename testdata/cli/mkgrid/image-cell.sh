mkgrid --image "$DATA/images/worm.png" --cell 3
