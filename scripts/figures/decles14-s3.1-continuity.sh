# title: The same edit without and with continuous slopes
# paper: A comparison of continuous (C0) and C1 splines: without the conditions, creases along the edges.
# seen: The same move with the same slaves. Above, the growth of areas jumps from triangle to triangle
#   and lines across the edges have kinks; below, nothing jumps but second derivatives.
mkgrid --rect 0,0,6,4 --cells 3x2 -o flat.grid
for c in 0 1; do
    decles-edit --continuity $c -e 'move v^4,2 by 1 0.6 reach 4' flat.grid -o c$c.grid
    draw-grid --layers jacobian,net,triangles -o decles14-s3.1-continuity-$c.png c$c.grid
    check-grid c$c.grid 2>&1 | grep -E '^(c1-residual|edges-c|local)' || true
done
