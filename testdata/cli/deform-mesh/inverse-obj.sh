# A 2.5-D map and back, in the plane zy, with normals and whatever else there is: to 12 digits.
mkgrid --rect 0,0,8,4 --cells 8x4 --depth=-1,2 | sed 's/^degree.*/&\nplane zy/' |
    decles-edit -e 'rotate v^4,2 about 4 2 by 20 reach 9' -e 'raise top v^4,2 by 0.7 reach 8' >g
cat >m.obj <<'END'
mtllib m.mtl
v 0.5 2.25 3.5 0.1 0.2 0.3
v -1 1 4 # at the bottom
v 2 3 4.5
vt 0 0
vn 0 0 1
vn 0.6 0 0.8
f 1/1/1 2/1/2 3/1/2
END
deform-mesh m.obj g >bent.obj
grep -c '^vn' bent.obj # copies: the map turns normals apart
deform-mesh --inverse --digits 12 bent.obj g
