# the points are finite, the determinant is not
mkgrid --rect 0,0,1,1 --cells 1x1 --degree 1 |
    awk '/^points/ { print; p = 1; next } p && NF == 2 { print 1e200 * $1, 1e200 * $2; next } { print }' >g
echo '0.5 0.25' >p.xy
deform-mesh p.xy g
deform-mesh --jacobian p.xy g
