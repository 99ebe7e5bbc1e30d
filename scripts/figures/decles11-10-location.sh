# title: Where a vertex lies: triangle, barycentric coordinates, height
# paper: Not known to us. By section 4.2 the vertices of the model are located in the grid once, and moved
#   by every deformation from there.
# picture: a vertex of the blood cell in its triangle
# picture: after an edit; its lines to the corners became curves
# seen: The vertex {vertex} lies in triangle {triangle}; its coordinates {coordinates} say what part of the
#   weight each corner has, and {heights} what part bottom and top have. These five numbers stay; only the
#   control points change.
cell=$DATA/models/red_blood_cell.obj
mkgrid --model "$cell" --cells 3 --pattern hex -o rest.grid
decles-edit -e 'move v@0,0 by 0.7 0.5 reach 5' rest.grid -o bent.grid
bary "$cell" rest.grid -o cell.bary
number=41
awk -v n=$number '
    FNR == 1 { file++ }
    file == 1 && $1 == "v" && ++v == n { print "vertex", v; x = $2; y = $3 }
    file == 2 && on && ++v2 == n { t = $1; b[0] = $2; b[1] = $3; b[2] = $4; a0 = $5; a1 = $6 }
    file == 2 && $1 == "points" { on = 1 }
    END {
        printf "triangle %d\ncoordinates %.3f, %.3f, %.3f\nheights %.3f, %.3f\n", t, b[0], b[1], b[2], a0, a1
        print t, x, y >"place"
    }' "$cell" cell.bary
read -r triangle x y <place
list-points "$triangle:5,0,0" "$triangle:0,5,0" "$triangle:0,0,5" rest.grid >corners
awk -v x="$x" -v y="$y" '{
    for (t = 0; t <= 40; t++) print x + t / 40 * ($4 - x), y + t / 40 * ($5 - y), "weights"
}' corners >straight
cut -d ' ' -f 1,2 straight | deform-mesh --format xy - bent.grid | awk '{ print $1, $2, "weights" }' >curved
for kind in straight curved; do awk '{ print } NR % 41 == 0 { print "" }' $kind >$kind.lines; done
draw-grid --model "$cell" --side domain --layers triangles,outline --lines straight.lines --line-width 2 --no-legend --width 400 \
    -o decles11-10-location-1.png bent.grid
draw-grid --model "$cell" --layers triangles,outline --lines curved.lines --line-width 2 --no-legend --width 400 \
    -o decles11-10-location-2.png bent.grid
