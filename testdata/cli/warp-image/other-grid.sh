# degree and depth do not matter, nor the plane; a map that folds shows one of the layers
printf 'P2\n8 8\n255\n' >image.pgm
seq 64 >>image.pgm
mkgrid --rect 0,0,8,8 --cells 2x2 --degree 3 --depth -1,1 >thick.grid
sed 's/^degree.*/&\nplane zy/' thick.grid >zy.grid
warp-image image.pgm thick.grid --to pnm | tail -n +4 >plain
warp-image image.pgm zy.grid --to pnm | tail -n +4 | cmp - plain
mkgrid --rect 0,0,8,8 --cells 4x4 | decles-edit -e 'move v@4,4 by 3 0 reach 3' - >fold.grid
check-grid fold.grid | grep one-to-one
warp-image image.pgm fold.grid --to pnm | tail -n +4 | od -v -An -tu1 -w8
