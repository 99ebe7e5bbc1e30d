# title: A Bezier patch of degree 5
# paper: Not known to us. The report's equations (1) and (2) define the map of one triangle by control points q_ijk,
#   i + j + k = 5, whose nominal positions are (i u0 + j u1 + k u2)/5.
# picture: the triangle with the nominal positions of its {points} control points, joined to the Bezier net,
#   and the image under control points some of which were moved
# seen: The image is drawn exactly: each side is a Bezier curve of the {side} points along it. Only the
#   three corners are interpolated; of all the others the image takes the direction, not the place. The
#   numbers are those of the files: corners first, then sides, then the inside.
printf '0 0\n5 0\n1 4\n' >one.xy
mkgrid --polygon one.xy --max-area 100 -o flat.grid
decles-edit -e 'move ^2,0 by 0.2 -0.9' -e 'move ^3,0 by 0.6 -0.7' -e 'move ^0.6,2.4 by -1.2 0.3' \
    -e 'move ^0.4,1.6 by -1 0.6' -e 'move ^2,1.6 by 0.5 0.5' -e 'move v^1,4 by 0.7 0.2' flat.grid -o patch.grid
echo "points $(list-points flat.grid | wc -l)"
echo "side $(list-points flat.grid | awk '$5 == 0' | wc -l)"
draw-grid --side both --layers triangles,net,points,labels -o decles14-03-patch.png patch.grid
