# title: What a line meets at an edge
# paper: Chapter 5: f is linear on each triangle, so lines are straight there; at an edge, the gradients of
#   the two triangles decide (Table 5.1). Either the line goes on through the edge, or both triangles push
#   it against the edge (compression) and it runs along it; both may also push away from it (expansion).
# seen: Of the edges that end inside, {compression} are compression edges and {expansion}
#   expansion edges, as seen uphill; lines pass through the others. Compression edges are the axes through the
#   maximum, and, in the two quarters where the cells' diagonals point at it, every diagonal: the gradients
#   of both triangles of a cell lean towards it, by one or two degrees, so lines drift to the diagonals and
#   merge there. In the other two quarters lines cross the diagonals, and merge when they come to an axis.
# picture: Compression and expansion edges in the triangulation
# picture: The same on a finer grid, with lines from the cage uphill
. "$HERE/lib/icc.sh"
legs 1 >legs.xy
map="icc-map --method grid"
$map --cell 0.13 --show edges legs.xy | grep -v unreached >edges
awk '!NF { if (label) n[label]++; label = ""; next } { label = $3 } END { for (l in n) print l, n[l] }' edges | sort
{ $map --cell 0.13 --show triangles legs.xy; echo; outline legs.xy; cat edges; } |
    draw icc-5.1-edges-1.png --width 470 --line-width 1.6 --colors dddddd,222222,009e73,d55e00
{
    $map --cell 0.05 --lines 100 legs.xy | awk 'NF { $3 = "line" } 1'
    echo
    outline legs.xy
    $map --cell 0.05 --show edges legs.xy | grep -v unreached
} | draw icc-5.1-edges-2.png --width 470 --colors 9ecae1,222222,009e73,d55e00
