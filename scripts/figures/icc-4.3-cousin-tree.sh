# title: The cousin tree
# paper: Chapter 4, Algorithm 3: a tree grows breadth first from the maximum; a vertex is the child of the
#   first neighbour that found it, and the thesis lets the order of the axes decide which that is.
# seen: Neighbours along x are found first on the left, along y on the right. {parents}
#   vertices have another parent in the other tree, but the depth of {depths} differs: the function depends
#   on the depth alone, so the order does not matter to it.
# picture: Neighbours along x first: the colour is the depth
# picture: Neighbours along y first
. "$HERE/lib/icc.sh"
legs 0 >legs.xy
n=0
for axes in xy yx; do
    icc-map --method grid --cell 0.15 --axes $axes --show tree legs.xy >$axes.tree
    icc-map --method grid --cell 0.15 --axes $axes --show grid legs.xy | grep -v outside >$axes.vertices
    n=$((n + 1))
    { outline legs.xy; cat $axes.tree; echo; cat $axes.vertices; } |
        draw icc-4.3-cousin-tree-$n.png --width 470 --dots 2.5 --line-width 1.5 --colors 222222,a0a0a0,c00000
done
# A line of a tree is a vertex with its depth, then its parent.
awk '
    !NF { next }
    child == "" { child = $1 " " $2; depth = $3; next }
    FILENAME == "xy.tree" { parent[child] = $1 " " $2; depth_of[child] = depth }
    FILENAME == "yx.tree" { n++; others += parent[child] != $1 " " $2; deeper += depth_of[child] != depth }
    { child = "" }
    END { print "parents", others, "of", n; print "depths", deeper ? deeper : "none" }' xy.tree yx.tree
