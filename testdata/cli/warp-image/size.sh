# twice as large by each filter, half as large by the mean of 2 x 2 samples
printf 'P2\n3 2\n255\n 10 20 40\n 80 160 240\n' >image.pgm
mkgrid --image image.pgm --cells 2 >image.grid
for filter in nearest linear cubic; do
    warp-image --filter $filter --size 6x4 --to pnm image.pgm image.grid | tail -n +4 | od -v -An -tu1 -w6
    echo
done
mkgrid --image "$DATA/images/worm.pgm" --cells 3 |
    warp-image --antialias 2 --size 8x6 --to pnm "$DATA/images/worm.pgm" | tail -n +4 | od -v -An -tu1 -w8
