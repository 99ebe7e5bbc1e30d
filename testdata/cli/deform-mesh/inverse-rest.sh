# Where nothing has moved, nothing moves back, by no bit; where only y has, x stays.
mkgrid --rect 0,0,8,4 --cells 8x4 | decles-edit -e 'move v^6,2 by 0 0.25 reach 3' >g
LC_ALL=C awk 'BEGIN { for (i = 0; i < 400; i++) printf "%.17g %.17g\n", 8 * ((i * 0.618) % 1), 4 * i / 400 }' >p.xy
deform-mesh p.xy g >q.xy
deform-mesh --inverse q.xy g >back.xy
paste -d ' ' p.xy q.xy back.xy | LC_ALL=C awk '
    { same += $2 == $4; moved += $2 != $4 }
    $1 != $5 || ($2 == $4 && $6 != $2) { print }
    ($6 - $2) ^ 2 > 1e-30 { print }
    END { print (same > 100 && moved > 100) ? "as expected" : same " " moved }'
