# the second triangle turns over
printf '%s\n' 'v 0 0 0' 'v 4 0 0' 'v 0 4 0' 'v 1 1 0' 'vt 0 0' 'vt 4 0' 'vt 0 4' 'vt 4 4' 'f 1/1 2/2 3/3' 'f 3/3 2/2 4/4' |
    render-checker --mark-folds --squares 1 --colors white,white --size 8x8 --antialias 1 --to pnm |
    tail -n +4 | od -v -An -tx1 -w24
