# what is sound and cannot be done; what cannot be read or written
try() { render-checker "$@"; echo $?; }
try --scale 1e9 "$DATA/good/obj-texture/sheared.obj"
try --texture missing.png "$DATA/good/obj-texture/sheared.obj"
try --texture "$DATA/images/worm.png" --max-pixels 3000 "$DATA/good/obj-texture/sheared.obj"
try --background none -o x.ppm "$DATA/good/obj-texture/sheared.obj"
printf '%s\n' 'v -1e308 0 0' 'v 1e308 0 0' 'v 0 1 0' 'vt 0 0' 'f 1/1 2/1 3/1' >far.obj
try far.obj
try "$DATA/models/virtual_worm_cuticle_red75.obj"
# pictures have at most so many pixels, of which the option tells
try --size 32767x32767 "$DATA/good/obj-texture/sheared.obj"
try --size 10x10 --max-pixels 99 "$DATA/good/obj-texture/sheared.obj"
try --scale 30 --max-pixels 99 "$DATA/good/obj-texture/sheared.obj"
