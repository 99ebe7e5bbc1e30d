# title: The types of control points in degree 5
# paper: Not known to us. The report's table 1 divides the control points into six types, on which the rules for
#   editing rest.
# seen: {corner} corners, {edge-corner} edge corners, {edge} edge points, {inner-corner} inner corners and
#   {inner-edge} inner edge points of eight triangles. Degree 5 has no interior points ({interior}); it is the
#   least degree in which corners of a side have nothing to do with each other, so that an edit stays local.
mkgrid --rect 0,0,2,2 --cells 2x2 -o flat.grid
for type in corner edge-corner edge inner-corner inner-edge interior; do
    echo "$type $(list-points --type $type flat.grid | wc -l)"
done
draw-grid --side domain --layers triangles,net,types --width 560 -o decles14-11-types.png flat.grid
