draw-grid --no-grid --to svg --width 200 --lines "$DATA/good/lines/mixed.lines"
