# title: The net closes in on the patch
# paper: Not known to us. A map given by (1) and (2) can be split by de Casteljau's scheme without a
#   change.
# picture: the patch of figure 3 with its net
# picture: the same map in 4 triangles
# picture: in 16 triangles
# seen: The three maps are the same: at {samples} places they differ by {difference} at most, which is
#   rounding. The control points of the parts lie nearer to the image; in the limit the net is the image.
printf '0 0\n5 0\n1 4\n' >one.xy
mkgrid --polygon one.xy --max-area 100 | decles-edit -e 'move ^2,0 by 0.2 -0.9' -e 'move ^3,0 by 0.6 -0.7' \
    -e 'move ^0.6,2.4 by -1.2 0.3' -e 'move ^0.4,1.6 by -1 0.6' -e 'move ^2,1.6 by 0.5 0.5' \
    -e 'move v^1,4 by 0.7 0.2' -o 1.grid
refine-grid 1.grid -o 2.grid
refine-grid 2.grid -o 3.grid
awk 'BEGIN { for (i = 1; i < 20; i++) for (j = 1; i + j < 20; j++) print (5 * i + j) / 20, 4 * j / 20 }' >places.xy
for n in 1 2 3; do
    deform-mesh --format xy places.xy $n.grid >$n.xy
    draw-grid --layers net,points,outline --width 300 -o decles14-04-subdivision-$n.png $n.grid
done
paste 1.xy 2.xy 3.xy | awk '
    { for (i = 3; i <= 6; i++) { e = $i - $(2 - i % 2); if (e < 0) e = -e; if (e > most) most = e } }
    END { printf "samples %d\ndifference %.1e\n", NR, most; exit most > 1e-14 }'
