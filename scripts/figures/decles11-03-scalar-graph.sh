# title: The graph of a scalar spline and its control points
# paper: The graph of a scalar spline over a triangle, with its control points and Bezier net.
# seen: A polynomial of degree 5 over one triangle: {count} coefficients, drawn as heights over their nominal
#   positions (i u0 + j u1 + k u2)/5. The net follows the graph as a polygon follows its Bezier curve: the
#   corners lie on the graph, at each corner the net's triangle is tangent to it, and the graph lies in the
#   convex hull of the net. The walls are those of a prism, whose bottom is the domain.
printf '0 0\n4 0\n1 3.5\n' >one.xy
mkgrid --polygon one.xy --max-area 100 --depth 0,1 -o flat.grid
decles-edit -e 'raise top 0:5,0,0 by 0.5' -e 'raise top 0:3,1,1 by 2.2' -e 'raise top 0:2,1,2 by 1.2' \
    -e 'raise top 0:1,3,1 by -0.9' -e 'raise top 0:0,3,2 by 0.8' -e 'raise top 0:4,1,0 by 1' \
    -e 'raise top 0:0,1,4 by -0.7' flat.grid -o graph.grid
echo "count $(list-points flat.grid | wc -l)"
render-model --grid graph.grid --no-model --layers glass,triangles,net,points --controls top --view -30,28 \
    --size 640x520 -o decles11-03-scalar-graph.png
