# Two preimages: the one in the triangle with the lower number, or that of the places of --bary.
mkgrid --rect 0,0,8,1 --cells 16x2 --degree 5 | LC_ALL=C awk '
    /^points/ { print; p = 1; next }
    p && NF == 2 { a = $1 * 6.6 / 8; r = 1 + $2; print r * sin(a), r * cos(a); next }
    { print }' >g
printf '0.1 0.5\n7.75 0.5\n4 0.5\n' >p.xy
deform-mesh p.xy g >q.xy
deform-mesh --inverse --any --digits 10 q.xy g
bary p.xy g | deform-mesh --inverse --any --bary - --digits 10 q.xy g
