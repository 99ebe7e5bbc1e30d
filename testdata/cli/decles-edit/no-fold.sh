# An edit that folds is refused with a triangle, a place and the value there; one that does not is as ever.
mkgrid --rect 0,0,8,6 --cells 4x3 >flat.grid
decles-edit --no-fold -e 'move v:7 by 0.5 0.5 reach 4' flat.grid | grep -v '^#' >guarded.grid
decles-edit -e 'move v:7 by 0.5 0.5 reach 4' flat.grid | grep -v '^#' | cmp - guarded.grid
decles-edit --no-fold -e 'move v:8 by 0.1 0' -e 'move v:7 by 3.5 0' flat.grid
