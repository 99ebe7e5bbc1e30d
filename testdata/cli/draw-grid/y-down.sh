mkgrid --rect 0,0,2,1 --cells 1x1 --degree 1 | decles-edit --continuity 0 -e 'move v^0,0 by -1 0' - |
    draw-grid --to svg --width 200 --y-down --layers outline
