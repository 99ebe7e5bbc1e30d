# A micrograph below, one unit a pixel and y down, or in a frame of its own.
mkgrid --image "$DATA/images/worm-254.png" --cells 2 --degree 1 -o a.grid
draw-grid --to svg --width 100 --image "$DATA/images/worm-254.png" a.grid | sed 's/base64,.*"/base64,.."/'
draw-grid --to svg --width 100 --no-grid --image "$DATA/images/worm-254.png" --frame 0,1,2,0 | sed 's/base64,.*"/base64,.."/'
