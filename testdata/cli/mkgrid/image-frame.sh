# y upwards, x backwards: the rectangle is the same
mkgrid --image "$DATA/images/worm.png" --frame -1,2,1,-0.5 --cells 2 --degree 1
mkgrid --image "$DATA/images/worm.png" --frame 1,-0.5,-1,2 --cells 2 --degree 1 --depth 0,1
