# Prisms around a triangle, another model as glass, a transparent background; the same bytes again.
printf 'v 0.5 0.25 0.5\nv 1.5 0.25 0.5\nv 1 0.75 0.5\nf 1 2 3\nl 1 2\n' >m.obj
printf 'v 0.5 0.25 0.2\nv 1.5 0.25 0.9\nv 1 0.75 0.5\nf 1 2 3\n' >other.obj
mkgrid --rect 0,0,2,1 --cells 1x1 --depth 0,1 | decles-edit -e 'raise top v^2,1 by 0.5 reach 3' -o a.grid
render-model --grid a.grid --compare other.obj --size 40x30 --to pnm m.obj | tail -c 3600 | od -An -v -tu1 -w120 |
    awk 'NR % 6 == 3'
for i in 1 2; do render-model --grid a.grid --background none m.obj -o $i.png; done
cmp 1.png 2.png
render-model --grid - m.obj -o 3.png --background none <a.grid && cmp 1.png 3.png
