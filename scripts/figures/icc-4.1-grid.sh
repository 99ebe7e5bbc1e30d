# title: The grid over the cage
# paper: Chapter 4, Algorithm 1: a regular grid is laid over the cage, each vertex is inside or outside,
#   and each cell is cut into two triangles.
# seen: A coarse grid, to have something to see: {grid}. Values are also given to three rings
#   of vertices outside, so that the function is defined wherever the cage passes. The grid stands a little
#   off the middle of the cage so that no side of a cage that is drawn on squared paper lies on its lines.
. "$HERE/lib/icc.sh"
legs 0 >legs.xy
icc-map --method grid --cell 0.2 --verbose --show triangles -o triangles legs.xy 2>&1 | sed 's/.*: cells of/grid cells of/'
icc-map --method grid --cell 0.2 --show grid -o vertices legs.xy
{ cat triangles; echo; outline legs.xy; cat vertices; } |
    draw icc-4.1-grid.png --width 560 --dots 3.5 --colors c8c8c8,222222,6baed6,e6550d,c00000
