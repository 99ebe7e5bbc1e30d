# many pictures by one program, of grids and meshes, as by many
mkgrid --rect 0,0,63,59 --cells 2x2 >rest.grid
printf '%s\n' "rest.grid a.png # at rest" "$DATA/good/obj-texture/sheared.obj b.tif" 'rest.grid c.ppm' >list
render-checker --texture "$DATA/images/worm.png" --size 40x30 --frames list
for picture in a.png b.tif c.ppm; do
    input=rest.grid
    [ $picture != b.tif ] || input=$DATA/good/obj-texture/sheared.obj
    render-checker --texture "$DATA/images/worm.png" --size 40x30 "$input" -o single-$picture
    cmp $picture single-$picture
done
