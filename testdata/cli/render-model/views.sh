# A pyramid on a square, in 12 x 8 pixels as numbers: from above, obliquely, along the plane, flat.
printf 'v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 1.5\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n' >p.obj
for view in '--view top' '' '--view 0,0' '--view 120,20 --shade flat' '--plane zy'; do
    echo "$view"
    render-model $view --to pnm --size 12x8 p.obj | tail -c 288 | od -An -v -tu1 -w36
done
