# a grid that moves nothing gives the image back, whatever holds it
for image in worm.png worm.tif worm.exr worm.pgm worm-msb.tif; do
    to=${image##*.}
    case $to in tif) to=tiff ;; pgm) to=pnm ;; esac
    for filter in nearest linear cubic; do
        mkgrid --image "$DATA/images/$image" --cells 5 | warp-image --filter $filter --to $to "$DATA/images/$image" >once
        mkgrid --image once --cells 3 --pattern hex --degree 2 | warp-image --filter $filter --to $to once | cmp - once
    done
done
mkgrid --image "$DATA/images/worm.pgm" --cells 5 | warp-image --to pnm "$DATA/images/worm.pgm" | cmp - "$DATA/images/worm.pgm"
