# title: Values outside the cage
# paper: Chapter 4, Algorithm 2: vertices outside get 0.95 times the value of their parent as well.
# seen: Taken literally, a vertex outside can be higher than a vertex inside that is its neighbour, and then f
#   rises from the cage outwards. Of lines uphill from {places} places on the bent cage, {literal}
#   leave it (orange), at least for a while. Where each vertex outside is lower than all of its neighbours inside, {inward} leave it:
#   that is the default here.
# picture: As Algorithm 2 says (--outside-values literal)
# picture: Lower than all neighbours inside (the default)
. "$HERE/lib/icc.sh"
legs 1 >legs.xy
places legs.xy 400 | awk '{ print $1, $2, 0.5 }' >middles
echo "places $(wc -l <middles)"
n=0
for how in literal inward; do
    map="icc-map --method grid --resolution 2 --outside-values $how --resolution-check warn"
    $map --verbose --from-coords legs.xy legs.xy middles 2>&1 >/dev/null |
        sed -n "s/.*leaving the cage: \([0-9]*\).*/$how \1/p"
    n=$((n + 1))
    { outline legs.xy; $map --lines 300 legs.xy | leaving legs.xy; } |
        draw icc-4.5-outside-values-$n.png --width 470 --colors 222222,8ab4d8,e6550d
done
