mkgrid --rect 0,0,1,1 --cells 1x1 --degree 10 | convert-grid --to msh | awk '/^.Elements/ { on = 1 } on'
