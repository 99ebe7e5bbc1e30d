mkgrid --image "$DATA/images/worm.png" --frame -1e308,0,1e308,1
