printf 'edits 1\nmove 0 by 0 0.5\nmove v^2,1 by 0.25 0.5 reach 3\n' >e.edits
mkgrid --rect 0,0,2,1 --cells 1x1 --degree 5 | draw-grid --to svg --width 200 --edit e.edits:3
