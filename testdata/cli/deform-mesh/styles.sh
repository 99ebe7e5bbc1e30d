# Only the numbers of v lines change: comments, weights, colours, blanks, groups, unknown lines pass.
cat >m.obj <<'END'
# v 9 9 9
mtllib a b.mtl
  v	1.500  +2e0   -0  0.5   # weight
v 1 1 3 0.25 .5 1
v 1 \
  2 3
vt 0.50 0
usemtl "red#1"
s off
f   1/1 -2/1 3 # a face
curv 0 1 1 2
nonsense v 1 2 3
END
deform-mesh --normals keep m.obj "$DATA/cli/deform-mesh/stretch.grid"
