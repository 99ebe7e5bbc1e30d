# Nothing to be seen; a plane that is not the grid's; a model and a grid that do not exist.
printf 'v 0 0 0\nv 1 0 0\n' >points.obj
mkgrid --rect 0,0,2,1 --cells 1x1 -o a.grid
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >m.obj
for words in points.obj '--grid a.grid --plane zy m.obj' nothing.obj '--grid nothing.grid m.obj'; do
    render-model --to pnm $words
    echo "status $?"
done
