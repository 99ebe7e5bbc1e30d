# The corners of surf have normals, too.
printf 'v 3 1 0\nv 1 3 0\nvn 0 1 0\nsurf 0 1 0 1 1/1/1 2/1/1\nfo 1//1 2//1 1//1\n' >m.obj
deform-mesh m.obj "$DATA/cli/deform-mesh/crease.grid"
deform-mesh --normals drop m.obj "$DATA/cli/deform-mesh/crease.grid"
