# title: The global Bezier net
# paper: Not known to us. The nets of all triangles together are the global net; distances between control
#   points are counted in its steps.
# picture: numbers of vertices and triangles
# picture: the control points and the net, at rest and deformed
# seen: {triangles} triangles share {vertices} vertices and {points} control points: what lies on a common
#   side is there once, so that the map cannot tear. Points near the left border did not move; others moved
#   as one corner in the middle went up and right.
mkgrid --rect 0,0,6,4 --cells 3x2 --pattern hex -o flat.grid
decles-edit -e 'move v^3.5,2 by 0.8 0.6 reach 7' flat.grid -o moved.grid
awk '/^(vertices|triangles|points) / { print }' flat.grid
draw-grid --side domain --layers triangles,labels --width 400 -o decles14-05-global-net-1.png flat.grid
draw-grid --side both --layers triangles,net,points -o decles14-05-global-net-2.png moved.grid
