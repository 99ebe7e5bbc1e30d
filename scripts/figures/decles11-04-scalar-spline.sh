# title: A scalar spline over a triangulation
# paper: Not known to us. Two scalar splines, sigma0 and sigma1, are the deformed bottom and top of the
#   prisms.
# picture: the graph of sigma1, the top of the prisms
# picture: its Bezier net
# seen: The top of {triangles} prisms, raised in the middle: {derived} coefficients around the raised one
#   follow so that the graph is smooth across the sides, which one cannot see on it. Outside, nothing moves.
mkgrid --rect 0,0,4,4 --cells 4x4 --pattern hex --depth 0,0.3 -o flat.grid
decles-edit --verbose -e 'raise top v^2,2 by 1.4 reach 5' flat.grid -o graph.grid 2>&1 |
    awk '{ print; for (i = 1; i < NF; i++) if ($i == "|D|") print "derived", $(i + 1) }'
awk '/^triangles / { print }' flat.grid
render-model --grid graph.grid --no-model --layers glass,triangles --view -20,25 --size 480x330 -o decles11-04-scalar-spline-1.png
render-model --grid graph.grid --no-model --layers triangles,net,points --controls top --view -20,25 --size 480x330 -o decles11-04-scalar-spline-2.png
