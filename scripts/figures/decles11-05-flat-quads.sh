# title: Smooth across a side: four points in a plane
# paper: Not known to us. The paper's theorem 3.1 says which control points on both sides of an edge must fit for
#   continuous derivatives.
# picture: only continuous: the quadrilaterals are bent along the side
# picture: C1: each of the five lies in a plane
# seen: Two triangles, the same coefficient raised. Over the side between them lie five quadrilaterals (yellow)
#   of two points on the side and one on each flank. The graph has no crease where each of them is flat. The
#   largest violated condition is {c0} of the size of its terms on the left, {c1} on the right.
mkgrid --rect 0,0,4,3 --cells 1x1 --depth 0,0.4 -o flat.grid
for c in 0 1; do
    decles-edit --continuity $c -e 'raise top v^0,0 by 0.9' flat.grid -o graph.grid
    check-grid graph.grid 2>/dev/null >report || true
    awk -v c=c$c '/^c1-relative-residual:/ { print c, $2 }' report
    render-model --grid graph.grid --no-model --layers triangles,net,points,quads --controls top --view 10,30 \
        --size 480x400 -o decles11-05-flat-quads-$((c + 1)).png
done
