# marks where a layer is turned over: green of each pixel
mkgrid --rect 0,0,4,2 --cells 4x2 | decles-edit -e 'move v@2,1 by 1.6 0 reach 3' - >fold.grid
render-checker --mark-folds --colors white,white --antialias 2 --size 24x12 --to pnm fold.grid |
    tail -n +4 | od -v -An -tu1 -w72 | awk '{ for (i = 2; i <= NF; i += 3) printf "%4d", $i; print "" }'
