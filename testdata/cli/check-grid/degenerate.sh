# A triangle that is mapped onto a line; control points are those of degree 1.
cat >flat.grid <<'END'
grid 1
degree 1
vertices 4
0 0
1 0
1 1
0 1
triangles 2
0 1 2
0 2 3
points 4
0 0
1 0
1 1
0.5 0.5
end
END
check-grid flat.grid
