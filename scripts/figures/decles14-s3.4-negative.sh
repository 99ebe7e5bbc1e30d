# title: A positive net with a negative Jacobian
# paper: [14] 3.4 says that a Bezier net whose triangles are all counter-clockwise has a positive Jacobian.
# seen: It has not: the {triangles} net triangles of this patch of degree 2 all have twice the area {area}, and
#   yet det grad phi is {det-value} in the middle of one side, where the patch {local} (magenta). check-grid finds
#   the place, {det-place} in weights of the corners. This counterexample is ours; the programs never trust the
#   net, but the coefficients of the determinant.
cat >bad.grid <<'GRID'
grid 1
degree 2
vertices 3
0 0
1 0
0 1
triangles 1
0 1 2
points 6
0 0
-2 -2
-2 0
-1 2
0 -2
-1 0
end
GRID
list-points bad.grid | awk '
    { split($2, part, ":"); place[part[2]] = $6 " " $7 }
    function area(a, b, c,    p, q, r) {
        split(place[a], p, " "); split(place[b], q, " "); split(place[c], r, " ")
        print "area", (q[1] - p[1]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[1] - p[1])
    }
    END {
        area("2,0,0", "1,1,0", "1,0,1"); area("1,1,0", "0,2,0", "0,1,1")
        area("1,0,1", "0,1,1", "0,0,2"); area("1,1,0", "0,1,1", "1,0,1")
    }' | tee areas
echo "triangles $(wc -l <areas)"
check-grid bad.grid 2>/dev/null | grep -E '^(local|det-)' || true
draw-grid --layers jacobian,triangles,net,points --side deformed --width 330 -o decles14-s3.4-negative.png bad.grid
