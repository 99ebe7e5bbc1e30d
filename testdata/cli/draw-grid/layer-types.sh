mkgrid --rect 0,0,2,1 --cells 1x1 --degree 5 |
    decles-edit -e 'move v^2,1 by 0.25 0.5 reach 3' | draw-grid --to svg --width 200 --layers types
