mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 1 --degree 2 | awk '
    /^points/ { print; p = 1; next }
    p && NF == 2 { print 2 * $1 + $2, 3 * $2; next }
    { print }' >g
printf '4 4\n0 4\n8 0\n8 -1e-13\n8 -1e-15\n' >p.xy
deform-mesh --inverse --outside keep --jacobian p.xy g
