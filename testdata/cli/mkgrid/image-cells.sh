mkgrid --image "$DATA/images/worm.png" --cells 3
