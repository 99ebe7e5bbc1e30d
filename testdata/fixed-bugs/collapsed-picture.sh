# SPDX-License-Identifier: GPL-3.0-or-later
# Maps onto a point or a line: the picture's box was rounding noise, and a picture of that took
# minutes. Now a side that is nothing but rounding has no length.
mkgrid --rect 0,0,63,59 --cells 4x4 >rest.grid
for columns in '0, 0' '$1, 0' '0, $2'; do
    awk "/^points/ { p = 1; print; next } p && NF > 1 { print $columns; next } { print }" rest.grid |
        render-checker --to pnm | head -n 2 | tail -n 1
done
