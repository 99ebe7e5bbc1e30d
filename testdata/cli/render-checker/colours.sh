# transparent squares, transparent ground: PNG has RGBA, OpenEXR halves
for to in png exr tiff; do
    render-checker --squares 4 --colors none,ff000080 --background none --size 5x2 --to $to "$DATA/good/obj-texture/sheared.obj" >picture.$to
done
pngcheck -q picture.png
render-checker --texture picture.png --to pnm --size 10x4 "$DATA/good/obj-texture/sheared.obj" | cksum
render-checker --texture picture.exr --to pnm --size 10x4 "$DATA/good/obj-texture/sheared.obj" | cksum
render-checker --texture picture.tiff --to pnm --size 10x4 "$DATA/good/obj-texture/sheared.obj" | cksum
