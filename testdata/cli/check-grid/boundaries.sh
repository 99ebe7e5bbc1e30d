# A square ring and a triangle: apart; in the hole; across the boundary; corner on corner; within the
# ring's body; a hair's breadth beside it, and on it.
ring() { # X Y: where the triangle's corner goes
    cat <<'RING'
grid 1
degree 1
vertices 11
0 0
12 0
12 12
0 12
3 3
9 3
9 9
3 9
20 0
22 0
20 2
triangles 9
0 1 4
1 5 4
1 2 5
2 6 5
2 3 6
3 7 6
3 0 7
0 4 7
8 9 10
points 11
0 0
12 0
12 12
0 12
3 3
9 3
9 9
3 9
RING
    LC_ALL=C awk -v x="$1" -v y="$2" 'BEGIN { print x, y; print x + 2, y; print x, y + 2; print "end" }'
}
for place in '20 0' '5 5' '-1.25 5' '12 12' '9.5 6' '12 5'; do
    echo "at $place"
    ring $place | check-grid | sed -n '/^boundary:/,/^one-to-one/p'
done
echo 'beside it'
ring 12 5 | sed 's/^12 5$/12.000000000000002 5/; s/^12 7$/12.000000000000002 7/' | check-grid | grep -e ^boundary: -e ^one
