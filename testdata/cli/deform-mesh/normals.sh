# A shared normal becomes two where the vertices turn it differently; only then are faces rewritten.
cat >m.obj <<'END'
v 3 1 0
v 2 1 0
v 1 3 0
vn 0 2 0
vn 0 0 1 # is the same everywhere
vn 1 1 0 # is unused
f 1/5/1 2/5/1 3/5/1
f 1//2 2//2 3//2
f -3//-3 -2//-3 -1//-3
vn 1 0 0 # changes its number
f 1//4 2//4 3//4
f 1/1/-1 2/1/-1 3//-4
f 1 2/1 3
END
deform-mesh m.obj "$DATA/cli/deform-mesh/crease.grid"
