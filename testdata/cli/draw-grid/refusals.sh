# A line without a statement; a statement that moves nothing; a point that is pinned.
mkgrid --rect 0,0,2,1 --cells 1x1 -o a.grid
printf 'edits 1\npin 3\nmove 3 by 1 1\n' >e.edits
for line in 1 2 3 9; do
    draw-grid --edit e.edits:$line a.grid
    echo "status $?"
done
