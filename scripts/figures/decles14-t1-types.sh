# title: The types of control points
# paper: Six types of control points of a spline of degree 5 and more, by their place in the Bezier net.
# seen: A spline of degree 6 on {triangles} triangles, since degree 5 has no interior points: {interior} interior
#   points, {inner-corner} inner corners (one at each corner of each triangle), {inner-edge} inner edge points along the
#   sides; on the sides themselves {edge} edge points between {edge-corner} edge corners next to the {corner} corners.
mkgrid --rect 0,0,2,1 --cells 2x1 --degree 6 -o flat.grid
awk '/^triangles / { print }' flat.grid
for type in corner edge-corner edge inner-corner inner-edge interior; do
    echo "$type $(list-points --type $type flat.grid | wc -l)"
done
draw-grid --side domain --layers triangles,net,types --width 640 -o decles14-t1-types.png flat.grid
