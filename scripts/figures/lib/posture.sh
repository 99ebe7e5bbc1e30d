# SPDX-License-Identifier: GPL-3.0-or-later
# Bends a worm, in its grid at rest, to a frame of the video: leaves posture.edits and the bent grid,
# outline.lines for draw-grid, bent.obj; prints the overlap, and fails where it is below 0.8.
# usage: sh -e posture.sh FRAME WORM.obj REST.grid BENT.grid
outline=$DATA/shapes2d/worm_outline_pairs/frame00$1_outline102.dat
list-points "$3" | awk '{ print "row", $5 }' | sort -u >rows
awk -v across=1.5 -v hinges=8 -v soft=1 -f "$HERE/lib/posture.awk" "$DATA/posture/midline-$1.csv" rows "$2" >posture.edits
decles-edit posture.edits "$3" -o "$4"
deform-mesh --normals drop "$2" "$4" >bent.obj
awk -f "$HERE/lib/overlap.awk" "$outline" bent.obj
awk 'NF { line = sprintf("%s %.4f outline", $1, -$2); print line; if (!first) first = line } END { print first }' "$outline" >outline.lines
