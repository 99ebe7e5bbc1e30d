# a grid that moves nothing shows what its triangles show; pixels as R G B, by rows
mkgrid --rect 0,0,4,2 --cells 2x1 >rest.grid
render-checker --squares 4 --colors black,white --size 8x4 --antialias 2 --to pnm rest.grid >grid.pnm
convert-grid --to obj rest.grid | render-checker --squares 4 --colors black,white --size 8x4 --antialias 2 --to pnm | cmp - grid.pnm
tail -n +4 grid.pnm | od -v -An -tu1 -w24
