# Continuous, not smooth: the middle of the common edge has moved.
cat >kinked.grid <<'END'
grid 1
degree 2
vertices 4
0 0
1 0
1 1
0 1
triangles 2
0 1 2
0 2 3
points 9
0 0
1 0
1 1
0 1
0.5 0
0.5 0.55
0 0.5
1 0.5
0.5 1
end
END
check-grid kinked.grid
