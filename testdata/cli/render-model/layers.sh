# A graph over two triangles without a model: each layer alone, of the top and of both, as numbers of
# pixels that are not white; the usual layers are three of them.
mkgrid --rect 0,0,2,1 --cells 1x1 --depth 0,0.5 | decles-edit -e 'raise top v^0,1 by 1 reach 3' -o a.grid
pixels() {
    render-model --grid a.grid --no-model --size 60x40 --antialias 1 --to pnm "$@" | tail -c 7200 |
        od -An -v -tu1 -w3 | grep -cv '255 255 255'
}
for layers in glass triangles points net quads points,net,quads; do
    echo "$layers: $(pixels --layers $layers --controls top) $(pixels --layers $layers)"
done
render-model --grid a.grid --no-model -o 1.png
render-model --grid a.grid --no-model --layers triangles,points,glass --controls both -o 2.png && cmp 1.png 2.png
