# title: The types of control points
# paper: Six types of control points of a spline of degree 5 and more, by their place in the Bezier net.
# seen: A spline of degree 6 on four triangles, since degree 5 has no interior points: one interior
#   point in each triangle, three inner corners, and the others as in the table.
mkgrid --rect 0,0,2,1 --cells 2x1 --degree 6 | draw-grid --side domain --layers triangles,net,types -o decles14-t1-types.png
