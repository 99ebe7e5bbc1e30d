mkgrid --image "$DATA/images/worm.png" --frame 0,1,2,1
