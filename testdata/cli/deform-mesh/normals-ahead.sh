# Vertices and normals may come after the faces that use them.
cat >m.obj <<'END'
f 1//1 2//1 3//2
v 3 1 0
v 1 3 0
v 1 2 0
vn 0 1 0
vn 1 0 0
END
deform-mesh m.obj "$DATA/cli/deform-mesh/crease.grid"
