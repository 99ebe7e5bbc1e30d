# title: A cell that is ill
# paper: Not known to us. Pathologies of cells are named among the uses.
# picture: a healthy red blood cell
# picture: thinned and bent to a sickle
# seen: One block and two statements: the whole is thinned to 0.45 across, then both ends are turned upwards, softly.
#   The map is one-to-one ({one-to-one}), so that the membrane cannot meet itself.
cell=$DATA/models/red_blood_cell.obj
mkgrid --model "$cell" --cells 8 --margin 0.1 -o rest.grid
{
    echo 'edits 1'
    list-points rest.grid | awk '{ print "row", $5 }' | sort -u |
        awk 'BEGIN { print "begin" } { printf "move box:-9,%s,9,%s by 0 %.17g\n", $2, $2, -0.55 * $2 } END { print "end" }'
    echo 'rotate box:1.6,-9,9,9 about 0.6 1.2 by 45 within 2.4'
    echo 'rotate box:-9,-9,-1.6,9 about -0.6 1.2 by -45 within 2.4'
} >sickle.edits
tail -n 2 sickle.edits
decles-edit sickle.edits rest.grid -o sickle.grid
check-grid sickle.grid >report || true
grep -E '^(local|one-to-one|det-lower)' report
deform-mesh "$cell" sickle.grid -o sickle.obj
render-model --grid rest.grid --layers triangles --view -10,60 --size 400x400 -o decles11-15-sickle-1.png "$cell"
render-model --grid sickle.grid --layers triangles --view -10,60 --size 400x400 -o decles11-15-sickle-2.png sickle.obj
