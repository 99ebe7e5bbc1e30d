# Bottom z = -2 + x / 4, top z = 6 + x: at x = 2, -1.5 is the bottom, 8 the top, 3.25 the middle.
mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 1 --degree 1 --depth -2,6 | LC_ALL=C awk '
    /^points/ { print; p = 1; next }
    p && NF == 4 { print $1 + 1, $2, $3 + $1 / 4, $4 + $1; next }
    { print }' >g
printf '3 2 8 top\n3 2 -1.5 bottom\n3 2 3.25 middle\n' >p.xyz
deform-mesh --inverse --jacobian p.xyz g
printf '3 2 8.001 above\n3 2 -1.501 below\n' >>p.xyz
deform-mesh --inverse p.xyz g
