# title: The same edit without and with continuous slopes
# paper: Not known to us. The report is about splines that are continuous with their slopes, C1.
# picture: only continuous (C0)
# picture: with continuous slopes (C1)
# seen: The same corner with the same slaves moves in both. Without the conditions the growth of areas (the
#   colours) jumps from triangle to triangle and lines have kinks where they cross a side: the largest
#   violated condition is {c0} of the size of its terms. With them nothing jumps but second derivatives:
#   {c1}, which is rounding.
mkgrid --rect 0,0,6,4 --cells 3x2 -o flat.grid
for c in 0 1; do
    decles-edit --continuity $c -e 'move v^4,2 by 1 0.6 reach 4' flat.grid -o c$c.grid
    check-grid c$c.grid 2>/dev/null >report || true
    awk -v c=c$c '/^c1-relative-residual:/ { print c, $2 }' report
    draw-grid --layers jacobian,net,triangles --width 430 -o decles14-06-continuity-$((c + 1)).png c$c.grid
done
