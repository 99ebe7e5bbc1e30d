# the grid's x is the points' z; an .xy list is in the grid's own plane
mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 1 --degree 1 |
    awk '/^points/ { print; p = 1; next } p && NF == 2 { print 2 * $1, $2; next }
        { print } /^degree/ { print "plane zy" }' >g
printf '10 3 1\n' >p.xyz
printf '1 3\n' >p.xy
deform-mesh --jacobian p.xyz g
deform-mesh --jacobian p.xy g
