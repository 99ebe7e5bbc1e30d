# An empty script copies the grid and adds a line to its history.
printf 'edits 1\n' >none.edits
mkgrid --rect 0,0,2,1 --cells 2x1 >a.grid
decles-edit none.edits a.grid | diff a.grid - | grep '^[<>]'
