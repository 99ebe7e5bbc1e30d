# Topology: a square with a hole, and crossed diagonals (singular vertices).
cat >hole.xy <<'END'
0 0
3 0
3 3
0 3
HOLE
1 1
2 1
2 2
1 2
END
mkgrid --polygon hole.xy | check-grid | sed -n '/^vertices/,/^overlap/p; /^rank/p'
