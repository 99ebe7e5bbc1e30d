# phi is one-to-one; psi is not where the top comes down to the bottom.
for height in 0.5 0 -0.5; do
    cat >prism.grid <<GRID
grid 1
degree 2
depth 0 1
vertices 3
0 0
1 0
0 1
triangles 1
0 1 2
points 6
0 0 0 1
1 0 0 1
0 1 0 1
0.5 0 0 $(LC_ALL=C awk "BEGIN { print 2 * $height - 1 }")
0 0.5 0 1
0.5 0.5 0 1
end
GRID
    check-grid prism.grid | grep -e ^thickness: -e ^one -e ^psi -e ^all
done
