# The report is printed all the same.
mkgrid --rect 0,0,2,1 --cells 2x1 | decles-edit -e 'move v@1,0 by 0.2 1.5 reach 3' -o folded.grid
check-grid --per-triangle folded.grid
