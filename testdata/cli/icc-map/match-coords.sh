# coordinates of matched cages: sides are those that both have then; both cages are given
printf '0.5 0.5\n1.5 0.5 # foot\n0 1\n2 1\n' >p
m="--match arclength $DATA/examples/L.xy $DATA/examples/square.xy"
icc-map --coords --digits 6 $m p
icc-map --coords $m p | icc-map --from-coords --digits 6 $m
icc-map --digits 6 $m p
