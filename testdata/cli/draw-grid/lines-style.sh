draw-grid --no-grid --to svg --width 200 --line-width 2 --dots 3 --colors '#222222,none' --dot-labels \
    --lines "$DATA/good/lines/mixed.lines"
draw-grid --no-grid --to svg --width 200 --squares 0.5 --dot-labels --no-legend --lines "$DATA/good/lines/mixed.lines"
