# what ends early is refused
mkgrid --image "$DATA/images/worm.pgm" --cells 1x1 --degree 1 >image.grid
for file in worm.png worm.tif worm.exr worm.jpg worm.pgm worm-progressive.jpg; do
    head -c $(($(wc -c <"$DATA/images/$file") * 3 / 4)) "$DATA/images/$file" >"$file"
    warp-image --to pnm "$file" image.grid; echo $?
done
