# All points of a half turn meet half-way: that is where it is limited, although its end folds nothing.
mkgrid --rect 0,0,8,6 --cells 4x3 >flat.grid
decles-edit --no-fold -e 'rotate all about 4 3 by 180' flat.grid | list-points v:0 v:19
decles-edit --no-fold=0.25 --limit -o turned.grid -e 'rotate all about 4 3 by 180' flat.grid
check-grid turned.grid | grep -E 'det-lower|det-upper'
