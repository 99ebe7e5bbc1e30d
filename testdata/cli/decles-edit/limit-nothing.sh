# So bold that hardly anything of it can be done.
mkgrid --rect 0,0,8,6 --cells 4x3 | decles-edit --no-fold --limit -e 'move v:7 by 1e7 0'
