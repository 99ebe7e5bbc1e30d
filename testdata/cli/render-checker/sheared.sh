# two squares a unit of the pattern; pixels as R G B, by rows
render-checker --square 1 --colors black,white --background 8080ff --size 10x4 --antialias 2 --to pnm "$DATA/good/obj-texture/sheared.obj" |
    tail -n +4 | od -v -An -tu1 -w30
