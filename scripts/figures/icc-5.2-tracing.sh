# title: Tracing an integral line
# paper: Chapter 5, Algorithms 4 to 7: a line is traced from triangle to triangle by topological decisions, up
#   to the maximum and down to the cage; arc lengths along it give t.
# seen: The lines of three points, uphill from the dot to the maximum and downhill to the cage. A line turns
#   where it leaves the edge that it follows, or where the rings of values outside turn the gradients near the
#   cage. On their last way uphill all lines follow one of four axes. The names (side k, lambda, t) of the points
#   are ({name-1}), ({name-2}) and ({name-3}).
. "$HERE/lib/icc.sh"
legs 0 >legs.xy
map="icc-map --method grid --cell 0.13"
printf '%s\n' '-0.4 -0.9' '0.75 0.3' '-0.55 0.62' >points
$map --coords legs.xy points >names
awk '{ printf "name-%d %d %.3f %.3f\n", NR, $1, $2, $3 }' names
# The way of a name is that from its place on the cage, t = 1, to the maximum, t = 0.
awk '{
    for (i = 0; i <= 200; i++) print $1, $2, $3 + (1 - $3) * i / 200, "downhill"
    print ""
    for (i = 0; i <= 200; i++) print $1, $2, $3 - $3 * i / 200, "uphill"
    print ""
}' names | $map --from-coords legs.xy legs.xy >ways
{
    $map --show triangles legs.xy
    echo
    outline legs.xy
    cat ways
    echo
    $map --show grid legs.xy | awk '$3 == "maximum" { print; print "" }'
    awk '{ print $1, $2, "point"; print "" }' points
} | draw icc-5.2-tracing.png --width 560 --line-width 1.8 --dots 3.5 --colors dddddd,222222,3182bd,e6550d,c00000,222222
