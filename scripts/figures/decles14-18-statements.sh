# title: Turning, scaling, pinning: several anchors in one edit
# paper: Not known to us. Anchors may be several; section 5.1 suggests positions for rotations and scalings,
#   too.
# picture: at rest
# picture: turned by 35 degrees
# picture: scaled by 1.5
# picture: two moves in one solve, and what lies below the middle pinned
# seen: The checkerboard shows the map: the middle is turned or scaled as a whole, and what is around
#   follows. All three maps are one-to-one ({turned}, {scaled}, {pinned}). In the
#   last picture the lower part is pinned and moves {below}.
mkgrid --rect 0,0,8,8 --cells 8x8 -o rest.grid
decles-edit -e 'rotate box:3,3,5,5 about 4 4 by 35 within 2.5' rest.grid -o turned.grid
decles-edit -e 'scale box:3,3,5,5 about 4 4 by 1.5 within 2.5' rest.grid -o scaled.grid
printf 'edits 1\npin box:0,0,8,3.4\nbegin\n  move v^2.5,5 by -0.6 0.6 reach 8\n  move v^5.5,5 by 0.6 0.6 reach 8\nend\n' >two.edits
decles-edit two.edits rest.grid -o pinned.grid
for name in turned scaled pinned; do check-grid $name.grid | sed -n "s/^one-to-one:/$name/p"; done
list-points box:0,0,8,3.4 rest.grid >before
list-points box:0,0,8,3.4 pinned.grid | cmp -s before - && echo 'below by not a bit'
n=0
for name in rest turned scaled pinned; do
    n=$((n + 1))
    render-checker --size 300x300 -o decles14-18-statements-$n.png $name.grid
done
