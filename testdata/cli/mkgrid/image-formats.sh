# every format: 63x59 pixels, the crop 40x30; TIFF in both byte orders, one is a BigTIFF
for name in worm.png worm.tif worm-msb.tif worm-big.tif worm.exr worm-crop.exr worm.pgm worm.jpg worm-progressive.jpg; do
    mkgrid --image "$DATA/images/$name" --cells 1x1 --degree 1 || exit
done
