# misuse, one line each
mkgrid --rect 0,0,4,4 --cells 2x2 >4.grid
try() { warp-image "$@"; echo $?; }
try
try "$DATA/images/worm.png" --filter box
try "$DATA/images/worm.png" --antialias 0
try "$DATA/images/worm.png" --size 4
try "$DATA/images/worm.png" --size 100000x100000 4.grid
try "$DATA/images/worm.png" --frame 0,0,0,1
try "$DATA/images/worm.png" --frame 0,0,1e308,-1e308,1
try "$DATA/images/worm.png" --frame=-1e308,0,1e308,1
try "$DATA/images/worm.png" --background 1,x
try "$DATA/images/worm.png" --background 1,1e39
try "$DATA/images/worm.png" --background x
try "$DATA/images/worm.png" --page 0
try "$DATA/images/worm.png" --max-pixels 0
try "$DATA/images/worm.png" --to jpeg
try "$DATA/images/worm.png" 4.grid -o a.jpg
try "$DATA/images/worm.png" 4.grid extra
try "$DATA/images/worm.png" --frames list 4.grid
try "$DATA/images/worm.png" --frames list -o a.png
try - --frames -
try - -
