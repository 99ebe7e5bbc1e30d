# A margin is kept for the determinant and for the thickness; a block is refused as a whole.
mkgrid --rect 0,0,8,6 --cells 4x3 --depth -1,1 >flat.grid
decles-edit --no-fold=0.6 -e begin -e 'move all by 1 0' -e 'raise top all by -0.5' -e end flat.grid | tail -n 2
decles-edit --no-fold=0.6 -e 'move all by 1 0' -e begin -e 'move all by 1 0' -e 'raise top all by -1' -e end flat.grid
