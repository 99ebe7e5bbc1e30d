# misuse, one line each
try() { render-checker "$@" "$DATA/good/obj-texture/sheared.obj"; echo $?; }
try --squares 0
try --square 0
try --square 1 --squares 2
try --colors red
try --colors red,pink
try --background '#12345'
try --antialias 17
try --size 10
try --size 0x10
try --scale 0
try --size 10x10 --scale 1
try --plane xx
try --frame 0,0,1,1
try --texture x.png --squares 3
try --texture x.png --frame 0,0,1
try --max-pixels 0
try --to gif
try -o picture.gif
try --to jpeg
try --frames list
render-checker --frames list -o a.png; echo $?
render-checker --texture - -; echo $?
