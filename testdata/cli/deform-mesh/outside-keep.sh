# Vertices and normals outside stay.
printf 'v 1 1 0\nv 5.0 1 7\nvn 0 1 1\nf 1//1 2//1 1//1\n' >m.obj
deform-mesh --outside keep m.obj "$DATA/cli/deform-mesh/stretch.grid"
