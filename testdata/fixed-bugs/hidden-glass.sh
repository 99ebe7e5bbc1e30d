# SPDX-License-Identifier: GPL-3.0-or-later
# A model to compare with was not to be seen inside the prisms of a grid, since of all panes only the
# nearest was drawn. Now one of each is: a row through the middle differs.
printf 'v 0 0 -9\nv 1 0 -9\nv 0 0 -8\nf 1 2 3\n' >below.obj
printf 'v 0.5 0.25 0.5\nv 1.5 0.25 0.5\nv 1 0.75 0.5\nf 1 2 3\n' >other.obj
mkgrid --rect 0,0,2,1 --cells 1x1 --degree 1 --depth 0,1 -o a.grid
for other in below other; do
    render-model --view top --grid a.grid --compare $other.obj --size 9x5 --to pnm below.obj |
        tail -c 135 | od -An -v -tu1 -w27 | awk 'NR == 3'
done
