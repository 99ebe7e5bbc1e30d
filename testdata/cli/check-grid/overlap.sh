# Two triangles that cross; both maps are the identity.
cat >crossed.grid <<'END'
grid 1
degree 1
vertices 6
0 0
4 0
0 4
1 1
5 1
1 5
triangles 2
0 1 2
3 4 5
points 6
0 0
4 0
0 4
1 1
5 1
1 5
end
END
check-grid crossed.grid
