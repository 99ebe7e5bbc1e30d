# cells along the longer side, here x; a narrow image has one cell across
mkgrid --image "$DATA/images/worm.png" --cells 2 --pattern cross --degree 1
mkgrid --image "$DATA/images/worm.png" --cells 2 --pattern hex --degree 1
printf 'P5 2 9 255 ' | mkgrid --image - --cells 3 --degree 1
