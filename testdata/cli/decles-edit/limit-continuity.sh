# The guard knows nothing of conditions: it works on a grid of degree 3. Of an option said twice the last counts.
mkgrid --rect 0,0,8,6 --cells 4x3 --degree 3 |
    decles-edit --no-fold=2 --no-fold --limit --continuity 0 -e 'move v:7 by 3 0 reach 2' >near.grid
check-grid near.grid 2>&1 | grep '^local'
