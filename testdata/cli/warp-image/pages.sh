# of one page there is the first only
mkgrid --image "$DATA/images/worm.tif" --cells 3 >image.grid
warp-image --page 1 --to pnm "$DATA/images/worm.tif" image.grid | cmp - "$DATA/images/worm.pgm"
warp-image --page 2 --to pnm "$DATA/images/worm.tif" image.grid; echo $?
warp-image --page 2 --to pnm "$DATA/images/worm.pgm" image.grid; echo $?
