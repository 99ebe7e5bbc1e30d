# one number for all channels, or one for each
printf 'P3\n2 1\n255\n 11 12 13 21 22 23\n' >image.ppm
mkgrid --image image.ppm --cells 2x1 | decles-edit -e 'move all by 1 0' - >shift.grid
for background in 5 7,8,9 300; do
    warp-image image.ppm shift.grid --to pnm --background $background | tail -n +4 | od -v -An -tu1
done
warp-image image.ppm shift.grid --to pnm --background 1,2; echo $?
