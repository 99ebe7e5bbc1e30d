# JPEG can be read
for image in worm.jpg worm-progressive.jpg; do
    mkgrid --image "$DATA/images/$image" --cells 5 | warp-image --to pnm "$DATA/images/$image" | head -n 3
done
