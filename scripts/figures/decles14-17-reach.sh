# title: How far an edit reaches
# paper: Not known to us. The user chooses which points may follow an anchor, as slaves.
# picture: reach 0: only what must follow
# picture: reach 3
# picture: reach 6
# picture: reach 12
# seen: The same corner is moved by the same way; slaves are the points within 0, 3, 6 and 12 steps of the
#   net ({derived-0}, {derived-3}, {derived-6} and {derived-12} points move with it). The farther the edit
#   reaches, the gentler it is: areas shrink to {least-0}, {least-3}, {least-6} and {least-12} at the least.
mkgrid --rect 0,0,8,6 --cells 8x6 -o flat.grid
n=0
for reach in 0 3 6 12; do
    decles-edit --verbose -e "move v^4,3 by 0.5 0.3 reach $reach" flat.grid -o moved.grid 2>&1 |
        awk -v tail=-$reach -f "$HERE/lib/counts.awk" | grep ^derived
    check-grid moved.grid 2>/dev/null >report || true
    sed -n "s/^det-lower:/least-$reach/p" report
    draw-grid --layers jacobian,triangles,outline --width 420 -o decles14-17-reach-$((n += 1)).png moved.grid
done
