# title: The configurations at the boundary
# paper: Figure A.1 enumerates what the neighbourhood of a vertex at the boundary can be. Its counts were not at hand.
# seen: Our own enumeration: the depths of the eight neighbours of a vertex v inside, less that of v, where not all
#   eight are inside (blank: outside). There are {configurations} of them, in {patterns} patterns of inside and
#   outside; {classes} that no rotation or reflection of the square makes equal are drawn. Around v the higher
#   neighbours and the lower ones are one run each, in all of them, whichever of two equal depths counts as higher, so
#   {critical} of them are critical.
# picture: Depths of the neighbours less that of v
awk -v columns=14 -f "$HERE/lib/icc-boundary.awk" >plate.lines 2>counts
cat counts
draw-grid --no-grid --lines plate.lines --squares 1 --dot-labels --colors b0b0b0,222222 --width 960 -o icc-A.1-boundary.png
