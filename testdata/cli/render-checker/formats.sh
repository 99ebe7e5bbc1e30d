# by name, by --to, on stdout
for name in a.png a.tif a.tiff a.exr a.ppm a.PNM; do
    render-checker --size 4x2 -o $name "$DATA/good/obj-texture/sheared.obj" && head -c 4 $name | od -An -tx1
done
render-checker --size 4x2 -o a --to exr "$DATA/good/obj-texture/sheared.obj" && head -c 4 a | od -An -tx1
render-checker --size 4x2 <"$DATA/good/obj-texture/sheared.obj" | head -c 4 | od -An -tx1
cmp a a.exr
