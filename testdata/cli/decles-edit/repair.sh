# A grid that is not C1 is refused where it is edited, repaired with --repair.
mkgrid --rect 0,0,2,1 --cells 2x1 | sed 's/^1 0.5$/1 0.6/; s/^1 0.4$/1 0.55/' >bent.grid
decles-edit -e 'move v:4 by 0.1 0' bent.grid 2>log
echo $?
sed 's/off by .*/off/' log
decles-edit --repair -n -e 'move v:4 by 0.1 0' bent.grid
