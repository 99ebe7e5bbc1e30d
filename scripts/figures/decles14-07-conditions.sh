# title: The quadrilateral conditions of a side, and at a vertex
# also: decles14-08
# paper: Not known to us. By (4) and (6), across each inner side d quadrilaterals of neighbouring control
#   points must be affine images, all by one map, of the domain's quadrilateral: then the slopes are
#   continuous.
# picture: one side: 5 conditions in degree 5
# picture: all sides at a vertex
# seen: Before and after an edit the yellow quadrilaterals are images of each other under affine maps, one
#   for each side: parallelograms stay parallelograms. Adjacent ones share points on the side. At a vertex
#   of six triangles the six conditions of ring 1 share so many points that two follow from the others: of
#   the {all} conditions in the second picture {rank} are independent. The relative residual is {c1-relative-residual}.
mkgrid --rect 0,0,2,2 --cells 1x1 | decles-edit -e 'move v^2,2 by 0.5 0.5 reach 4' |
    draw-grid --side both --layers triangles,net,quads,points -o decles14-07-conditions-1.png
mkgrid --rect 0,0,2,2 --cells 2x2 -o flat.grid
decles-edit -e 'rotate v^1,1 about 1 1 by 30 reach 4' flat.grid -o turned.grid
decles-edit --verbose -e 'move v^1,1 by 0.1 0 reach 20' flat.grid 2>&1 >/dev/null | awk -f "$HERE/lib/counts.awk" >counts
awk '$1 == "conditions" { print "all", $2 } $1 == "rank"' counts
check-grid turned.grid | grep '^c1-relative-residual'
draw-grid --side both --layers triangles,net,quads,points -o decles14-07-conditions-2.png turned.grid
