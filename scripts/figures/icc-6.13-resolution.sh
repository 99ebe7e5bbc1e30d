# title: Limits: a grid that is too coarse
# paper: The thesis concludes with a discussion of limitations that come from piecewise linear interpolation and from
#   the grid (says its abstract).
# seen: The thesis does not say which grid is fine enough. Here four tests decide whether a grid has the topology of the
#   cage. This neck of a dumbbell is narrower than a cell: {coarse-1};
#   {coarse-2}. So the right half has no values, lines from there
#   get stuck, and the grid is refused. Without --cell, cells are chosen by the width of the neck and the tests: {fine}.
# picture: Cells of 0.45
# picture: The cells that icc-map chooses
. "$HERE/lib/icc.sh"
printf '%s\n' '0 0' '3 0' '3 1.3' '4.2 1.3' '4.2 0' '7 0' '7 3' '4.2 3' '4.2 1.7' '3 1.7' '3 3' '0 3' >neck.xy
map='icc-map --method grid --cell 0.45 --resolution-check warn'
icc-map --method grid --cell 0.45 --show grid neck.xy >/dev/null 2>&1 && exit 1
$map --show grid neck.xy 2>notes >vertices
sed 's/.*cells of 0.45, //' notes | awk '{ print "coarse-" NR, $0 }'
{
    $map --show triangles neck.xy
    echo
    outline neck.xy
    $map --lines 60 neck.xy | awk 'NF { $3 = "line" } 1'
    echo
    cat vertices
} 2>notes | draw icc-6.13-resolution-1.png --width 470 --dots 2.5 --colors dddddd,222222,6baed6,9ecae1,e6550d,c00000
icc-map --method grid --verbose --show grid neck.xy 2>&1 >vertices | sed 's/.*: cells of/fine cells of/'
{
    outline neck.xy
    icc-map --method grid --lines 60 neck.xy | awk 'NF { $3 = "line" } 1'
    echo
    cat vertices
} | draw icc-6.13-resolution-2.png --width 470 --dots 1 --colors 222222,6baed6,9ecae1,e6550d,c00000
