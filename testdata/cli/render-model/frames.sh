# Two models in one grid, by one program as by two.
printf 'v 0.5 0.25 0.5\nv 1.5 0.25 0.5\nv 1 0.75 0.5\nf 1 2 3\nl 1 2\n' >m.obj
printf 'v 0.5 0.25 0.2\nv 1.5 0.25 0.9\nv 1 0.75 0.5\nf 1 2 3\n' >n.obj
mkgrid --rect 0,0,2,1 --cells 1x1 --depth 0,1 -o a.grid
printf 'm.obj m.png\nn.obj n.png\n' | render-model --grid a.grid --compare n.obj --size 40x30 --frames -
for name in m n; do render-model --grid a.grid --compare n.obj --size 40x30 $name.obj | cmp - $name.png; done
