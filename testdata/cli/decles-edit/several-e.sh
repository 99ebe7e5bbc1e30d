# -e may be repeated; each is a line, and a block may take several.
mkgrid --rect 0,0,2,1 --cells 2x1 >a.grid
decles-edit -n -e begin -e 'move v:4 by 0.1 0' -e 'suggest 24 by 0.1 0' -e end a.grid
decles-edit -e 'move v:4 by 0.1 0' -e 'mvoe 3 by 1 1' a.grid
