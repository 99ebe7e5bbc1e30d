# X = 2 x + y, Y = 3 y backwards; columns 0.5 -1/6 0 1/3, determinant 1/6. All but the numbers stays.
mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 1 --degree 2 | awk '
    /^points/ { print; p = 1; next }
    p && NF == 2 { print 2 * $1 + $2, 3 * $2; next }
    { print }' >g
printf '3 3 red # comment\n8 0\n\n\tHOLE\r\n12 12 # a corner\n6  6' >p.xy
deform-mesh --inverse p.xy g
echo .
deform-mesh --inverse --jacobian p.xy g
echo .
