# title: A positive net with a negative Jacobian
# paper: [14] 3.4 says that a Bezier net whose triangles are all counter-clockwise has a positive Jacobian.
# seen: It has not: the four triangles of this net of degree 2 have twice the area 2 each, and yet det
#   grad phi is -4 (relative to the domain: -4) in the middle of one side, where the patch is folded
#   (magenta). check-grid finds the place.
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
check-grid bad.grid 2>/dev/null | grep -E '^(local|det-)' || true
draw-grid --layers jacobian,triangles,net,points --side deformed --width 500 -o decles14-s3.4-negative.png bad.grid
