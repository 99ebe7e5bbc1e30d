# title: The function
# paper: Chapter 4: the function is 10 at the maximum and 0.95 times the parent's value at each child. It has
#   no other critical point: every other vertex has a higher neighbour, its parent.
# seen: The values at the vertices, and on a finer grid. They depend on the number of steps to the
#   maximum along the axes only, so curves of equal value are diagonal, and all gradients inside lie near
#   a diagonal: this is why lines run into ridges along the axes and merge there (figure 6.12).
# picture: The values on a coarse grid, three rings outside included
# picture: On a finer grid, with lines from the cage uphill
. "$HERE/lib/icc.sh"
legs 0 >legs.xy
{ outline legs.xy; icc-map --method grid --cell 0.17 --show values legs.xy; } |
    draw icc-4.4-values-1.png --width 560 --squares 0.17 --dot-labels --colors 222222
{
    outline legs.xy
    icc-map --method grid --cell 0.03 --show values legs.xy
    echo
    icc-map --method grid --cell 0.03 --lines 60 legs.xy | awk 'NF { $3 = "line" } 1'
} | draw icc-4.4-values-2.png --width 400 --squares 0.03 --colors 222222,ffffff
