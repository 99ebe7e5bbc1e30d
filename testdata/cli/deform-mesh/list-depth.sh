# sigma1 = 6 + x lifts the top; .xy sees phi alone
mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 1 --degree 1 --depth -2,6 | awk '
    /^points/ { print; p = 1; next }
    p && NF == 4 { print $2, $1, $3, $4 + $1; next }
    { print }' >g
printf '1 2 6 top\n1 2 -2 bottom\n1 2 2 middle\n' >p.xyz
deform-mesh --jacobian p.xyz g
printf '1 2 6 no depth\n' | deform-mesh --format xy --jacobian - g
