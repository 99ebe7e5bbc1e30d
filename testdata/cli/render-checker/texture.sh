# an image a world unit wide, upright, on a mesh that is as large: itself
printf 'P5\n3 2\n255\nabcdef' >image.pgm
printf '%s\n' 'v 0 0 0' 'v 3 0 0' 'v 3 2 0' 'v 0 2 0' 'vt 0 0' 'vt 1 0' 'vt 1 1' 'vt 0 1' 'f 1/1 2/2 3/3 4/4' >square.obj
render-checker --texture image.pgm --frame 0,1,1,0 --antialias 1 --size 3x2 --to pnm square.obj; echo
render-checker --texture image.pgm --frame 0,0,1,1 --antialias 1 --size 3x2 --to pnm square.obj; echo
render-checker --texture image.pgm --frame 0,1,2,0 --antialias 1 --size 3x2 --to pnm square.obj | tail -c 18
