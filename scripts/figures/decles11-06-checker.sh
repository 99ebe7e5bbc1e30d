# title: Continuous slopes, seen on a pattern
# paper: Not known to us. The paper's method makes the deformation C1, since creases would show on the models.
# picture: a pattern through a map that is only continuous
# picture: through a C1 map, by the same edit
# seen: A corner in the middle is moved in both. On the left the lines of the pattern bend where they cross
#   sides of triangles; on the right they are smooth.
mkgrid --rect 0,0,6,6 --cells 3x3 -o flat.grid
for c in 0 1; do
    decles-edit --continuity $c -e 'move v^4,4 by -0.8 -0.6 reach 4' flat.grid |
        render-checker --squares 24 --size 400x400 -o decles11-06-checker-$((c + 1)).png
done
