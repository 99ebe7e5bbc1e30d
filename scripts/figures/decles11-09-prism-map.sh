# title: What a deformed prism does to the space in it
# paper: Not known to us. Equation (9): a point at height z between a and b goes to phi(x,y), at the height
#   that divides sigma0 and sigma1 as z divides a and b.
# picture: two prisms at rest, with lines at five heights
# picture: deformed by phi, sigma0 and sigma1
# seen: Lines that were at one height lie on surfaces between the bottom and the top, at equal parts of the
#   thickness; upright lines stay upright and straight. So bending in the plane never tilts the model.
mkgrid --rect 0,0,2,2 --cells 1x1 --depth 0,1 -o rest.grid
printf 'edits 1\nmove v^2,2 by 0.5 0.3 reach 3\nraise top v^2,0 by 0.7 reach 3\nraise bottom v^0,0 by 0.4 reach 2\nmove v^0,2 by 0 -0.4 reach 2\n' >bend.edits
decles-edit bend.edits rest.grid -o bent.grid
awk 'BEGIN {
    for (h = 0; h <= 4; h++) for (i = 0; i <= 4; i++) for (way = 0; way < 2; way++) {
        for (t = 0; t <= 20; t++) print "v", way ? i / 2 : t / 10, way ? t / 10 : i / 2, h / 4
        printf "l"
        for (t = 0; t <= 20; t++) printf " %d", ++n
        print ""
    }
    for (i = 0; i <= 4; i += 2) for (j = 0; j <= 4; j += 2) {
        print "v", i / 2, j / 2, 0; print "v", i / 2, j / 2, 1
        n += 2
        print "l", n - 1, n
    }
}' >lines.obj
deform-mesh lines.obj bent.grid -o bent.obj
render-model --grid rest.grid --layers glass,triangles --view -30,25 --size 460x360 -o decles11-09-prism-map-1.png lines.obj
render-model --grid bent.grid --layers glass,triangles --view -30,25 --size 460x360 -o decles11-09-prism-map-2.png bent.obj
