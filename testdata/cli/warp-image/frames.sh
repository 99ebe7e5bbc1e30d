# many pictures by one program, as by many
mkgrid --image "$DATA/images/worm.pgm" --cells 4 >rest.grid
for angle in 10 20 30; do
    decles-edit -e "rotate v@31,29 about 31 29 by $angle reach 12" rest.grid >$angle.grid
    echo "$angle.grid frame-$angle.png   # degrees"
    warp-image "$DATA/images/worm.pgm" $angle.grid -o single-$angle.png
done >list
warp-image "$DATA/images/worm.pgm" --frames list
for angle in 10 20 30; do cmp single-$angle.png frame-$angle.png; done
warp-image "$DATA/images/worm.pgm" --frames - --to pnm <<'LIST'
30.grid picture
LIST
head -n 2 picture
pngcheck -q frame-*.png
