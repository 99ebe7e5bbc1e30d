# a bent one, with lines, with other axes and depth; checksums of pixels
mkgrid --rect 0,0,4,2 --cells 4x2 | decles-edit -e 'rotate v@2,1 about 2 1 by 10 reach 9' - >bent.grid
render-checker --to pnm --size 160x90 bent.grid | cksum
render-checker --to pnm --size 160x90 --mesh-lines --y-down --square 0.3 bent.grid | cksum
mkgrid --rect 0,0,4,2 --cells 4x2 --depth -1,1 | sed 's/^degree.*/&\nplane zy/' |
    decles-edit -e 'rotate v@2,1 about 2 1 by 10 reach 9' - | render-checker --to pnm --size 160x90 | cksum
