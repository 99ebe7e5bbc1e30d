# title: The quadrilateral conditions
# paper: Across each inner edge, d quadrilaterals of neighbouring control points must be images of the
#   domain's quadrilaterals under one affine map each: then the map has continuous slopes.
# seen: The quadrilaterals of two triangles, and of six around a vertex, before and after an edit. At a
#   vertex six of them share points, and two of the six conditions follow from the others.
mkgrid --rect 0,0,2,2 --cells 1x1 | decles-edit -e 'move v^2,2 by 0.5 0.5 reach 4' |
    draw-grid --side both --layers triangles,net,quads,points -o decles14-s3.3-conditions-1.png
mkgrid --rect 0,0,2,2 --cells 2x2 | decles-edit -e 'rotate v^1,1 about 1 1 by 30 reach 4' |
    draw-grid --side both --layers triangles,net,quads,points -o decles14-s3.3-conditions-2.png
