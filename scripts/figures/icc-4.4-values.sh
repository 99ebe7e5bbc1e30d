# title: The function
# paper: Chapter 4: the function is 10 at the maximum and 0.95 times the parent's value at each child. It has
#   no other critical point: every other vertex has a higher neighbour, its parent.
# seen: The values at the vertices, and on a finer grid. They depend on the number of steps to the maximum along
#   the axes only, so curves of equal value are diagonal, and so are all gradients inside, within 1.5 degrees. Lines run
#   along a diagonal until they meet an axis, where they merge (figure 6.12): of the length of the lines that are
#   drawn, {diagonal} % is within 1.5 degrees of a diagonal and {axis} % along the axes.
# picture: The values on a coarse grid, three rings outside included
# picture: On a finer grid, with lines from the cage uphill
. "$HERE/lib/icc.sh"
legs 0 >legs.xy
{ outline legs.xy; icc-map --method grid --cell 0.17 --show values legs.xy; } |
    draw icc-4.4-values-1.png --width 560 --squares 0.17 --dot-labels --colors 222222
icc-map --method grid --cell 0.03 --lines 60 legs.xy >lines
awk '
    !NF { begun = 0; next }
    begun {
        dx = $1 - x; dy = $2 - y
        if (dx < 0) dx = -dx
        if (dy < 0) dy = -dy
        step = sqrt(dx^2 + dy^2)
        slope = 57.29578 * atan2(dy, dx)
        sum += step
        if (slope > 43.5 && slope < 46.5) diagonal += step
        if (slope < 1e-3 || slope > 90 - 1e-3) axis += step
    }
    { x = $1; y = $2; begun = 1 }
    END { printf "diagonal %.0f\naxis %.0f\n", 100 * diagonal / sum, 100 * axis / sum }' lines
{
    outline legs.xy
    icc-map --method grid --cell 0.03 --show values legs.xy
    echo
    awk 'NF { $3 = "line" } 1' lines
} | draw icc-4.4-values-2.png --width 400 --squares 0.03 --colors 222222,ffffff --no-legend
