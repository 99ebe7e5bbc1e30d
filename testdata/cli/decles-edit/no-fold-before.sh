# What folded before is said to have done so; it may be mended.
mkgrid --rect 0,0,8,6 --cells 4x3 | decles-edit -e 'move v:7 by 3.5 0' >folded.grid
decles-edit --no-fold -e 'move v:7 by -3.5 0' folded.grid | check-grid | grep local
decles-edit --no-fold -e 'move v:7 by 0.5 0' folded.grid
echo $?
decles-edit --no-fold --limit -e 'move v:7 by -3.5 0' folded.grid
