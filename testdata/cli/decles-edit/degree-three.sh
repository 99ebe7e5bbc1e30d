# Degree 3 has too little freedom for C1, and enough for continuity.
mkgrid --rect 0,0,2,1 --cells 2x1 --degree 3 >a.grid
decles-edit -n --continuity 0 -e 'move v:4 by 0.1 0 reach 1' a.grid
decles-edit -e 'move v:4 by 0.1 0' a.grid
