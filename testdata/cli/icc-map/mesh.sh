# twice the same: a square with six vertices, and one with four that are matched
printf '0 0\n1 0\n1 0.5\n1 1\n0.5 1\n0 1\n' >six.xy
icc-map --mesh 0.5 --digits 5 "$DATA/examples/L.xy" six.xy | tee six
icc-map --mesh 0.5 --digits 5 --match arclength "$DATA/examples/L.xy" "$DATA/examples/square.xy" >four
tail -n +2 six >a
tail -n +2 four | cmp - a
