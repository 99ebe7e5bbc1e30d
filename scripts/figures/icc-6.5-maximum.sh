# title: The choice of the maximum
# paper: The right half of the thesis' figure 6.5 has another maximum than the one that the grassfire finds.
# seen: The maximum where the grassfire ends, and one in a leg, in both cages. The map stays what it is on the
#   cage, but all lines inside change: from the grassfire's maximum the longest line is {longest-1} units, from the
#   other one {longest-2}.
# picture: Maximum by grassfire: lines
# picture: Maximum in a leg: lines
# picture: Maximum by grassfire: the map
# picture: Maximum in a leg: the map
. "$HERE/lib/icc.sh"
legs 0 >from.xy
legs 0.6 >to.xy
icc-map --mesh 0.001 from.xy from.xy >rest.obj
echo '1 0' >place
at=$(icc-map from.xy to.xy place | tr ' ' ,)
n=0
for maximum in '' "--maximum=1,0,$at"; do
    n=$((n + 1))
    map="icc-map --method grid --resolution 2 $maximum"
    ${map%,*,*} --lines 100 from.xy >lines
    awk -v name="longest-$n" '
        !NF { last = 0; length_of = 0; next }
        last { length_of += sqrt(($1 - x)^2 + ($2 - y)^2); if (length_of > longest) longest = length_of }
        { x = $1; y = $2; last = 1 }
        END { printf "%s %.2f\n", name, longest }' lines
    { outline from.xy; awk 'NF { $3 = "line" } 1' lines; } |
        draw icc-6.5-maximum-$n.png --width 400 --no-legend --colors 222222,6baed6
    $map --model rest.obj from.xy to.xy | render-checker --size 400x400 --squares 20 --mark-folds -o icc-6.5-maximum-$((n + 2)).png
done
