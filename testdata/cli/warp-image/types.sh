# types and channels are kept; what a format cannot hold is refused
mkgrid --image "$DATA/images/worm.exr" --cells 3 >image.grid
try() { warp-image "$@" image.grid; echo $?; }
try "$DATA/images/worm.exr" -o a.exr
try a.exr -o b.tif
try b.tif -o c.exr
cmp a.exr c.exr
try a.exr -o a.png
try a.exr
try "$DATA/images/worm.png" -o a.exr
