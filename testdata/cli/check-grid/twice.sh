# Five triangles around a vertex, each with a positive determinant, whose images wind round it twice.
cat >twice.grid <<'GRID'
grid 1
degree 1
vertices 6
0 0
10 0
3 10
-8 6
-8 -6
3 -10
triangles 5
0 1 2
0 2 3
0 3 4
0 4 5
0 5 1
points 6
0 0
10 0
-8 6
3 -10
3 10
-8 -6
end
GRID
check-grid twice.grid
