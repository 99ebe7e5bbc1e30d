# the corners of the letter, and the middle of its foot
printf '0 0\n2 0\n2 1\n1 1\n1 2\n0 2\n1 0\n' >p
icc-map --match arclength --digits 6 "$DATA/examples/L.xy" "$DATA/examples/square.xy" p
# the inner corner stays at corner 2 of the square, the first one goes to corner 1
icc-map --match arclength --anchor 3:2 --anchor 0:1 --digits 6 \
    "$DATA/examples/L.xy" "$DATA/examples/square.xy" p
