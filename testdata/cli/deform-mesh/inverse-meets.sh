# A strip bent until its ends overlap: one-to-one near every point, but not as a whole.
mkgrid --rect 0,0,8,1 --cells 16x2 --degree 5 | LC_ALL=C awk '
    /^points/ { print; p = 1; next }
    p && NF == 2 { a = $1 * 6.6 / 8; r = 1 + $2; print r * sin(a), r * cos(a); next }
    { print }' >g
printf '1.5 0\n' >p.xy
deform-mesh --inverse p.xy g
