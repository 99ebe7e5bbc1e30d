convert-grid --to obj --steps 1000 <<END | awk '{ n[$1]++ } $1 == "f" { last = $0 } END { print n["v"], n["vt"], n["f"], last }'
grid 1
degree 1
vertices 3
0 0
1 0
0 1
triangles 1
0 1 2
points 3
0 0
1 0
0 1
end
END
