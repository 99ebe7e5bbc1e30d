# Corners and edges of the grid, and its boundary, which a rotation by an odd angle rounds.
mkgrid --rect 0,0,4,4 --cells 4x4 | decles-edit -e 'rotate all about 1 7 by 33' >g
LC_ALL=C awk 'BEGIN { for (x = 0; x <= 8; x++) for (y = 0; y <= 8; y++) print x / 2, y / 2 }' >p.xy
deform-mesh p.xy g | deform-mesh --inverse --format xy - g | paste -d ' ' p.xy - | LC_ALL=C awk '
    function off(a, b) { return a < b ? b - a : a - b }
    off($1, $3) > 8e-15 || off($2, $4) > 8e-15 { print }
    END { print NR }'
