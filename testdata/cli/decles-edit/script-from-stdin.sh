# Script or grid may come from stdin, not both.
mkgrid --rect 0,0,2,1 --cells 2x1 >a.grid
printf 'edits 1\nmove v:4 by 0.1 0\n' | decles-edit -n - a.grid
printf 'edits 1\nmove v:4 by\n' | decles-edit - a.grid
echo $?
decles-edit - - <a.grid
