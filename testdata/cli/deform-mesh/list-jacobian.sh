# X = 2 x + y, Y = 3 y: columns 2 1 0 3, determinant 6
mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 1 --degree 2 | awk '
    /^points/ { print; p = 1; next }
    p && NF == 2 { print 2 * $1 + $2, 3 * $2; next }
    { print }' >g
printf '1 1 red # comment\n4 0\nHOLE\n2 2#c\n' | deform-mesh --format xy --jacobian - g
