# The second half of a block is refused: no grid, not even the first half.
decles-edit -e begin -e 'move v:4 by 0.1 0' -e 'raise top v:4 by 1' -e end \
    "$DATA/good/grid/square.grid"
