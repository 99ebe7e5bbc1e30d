# A line without a statement; a statement that moves nothing; a point that is pinned.
mkgrid --rect 0,0,2,1 --cells 1x1 -o a.grid
printf 'edits 1\npin 3\nmove 3 by 1 1\n' >e.edits
for line in 1 2 3 9; do
    draw-grid --edit e.edits:$line a.grid
    echo "status $?"
done
# Too many pixels, of a picture and of an image.
for words in '--width 32767 a.grid' "--no-grid --max-pixels 9 --image $DATA/images/worm-254.png"; do
    draw-grid $words | wc -c
done
