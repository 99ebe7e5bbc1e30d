# title: Limits: lines that merge
# paper: The thesis concludes with a discussion of limitations that come from piecewise linear interpolation and from
#   the grid (says its abstract).
# seen: Lines merge on compression edges, and from the cage no line uphill comes to some triangles of the grid at
#   all: {unreached} in the bent cage, {part} % of its area. What is left is reached by few points: of {points}
#   points on a square raster {collapsed} % lie where the map collapses (a triangle of 1e-6 units becomes one
#   without area), and their images crowd on ridges, with wide gaps between them. A finer
#   grid does not help: at 5 times the resolution of Table 6.1 it is {finer} %.
# picture: Compression edges, and a dot in each triangle that no line comes to
# picture: The images of points of a square raster
. "$HERE/lib/icc.sh"
legs 0 >from.xy
legs 1 >to.xy
map='icc-map --method grid --resolution 2'
$map --show edges to.xy >edges
inside=$($map --verbose --show grid to.xy 2>&1 >/dev/null | sed 's/.* \([0-9]*\) vertices inside.*/\1/')
awk -v inside="$inside" '$3 == "unreached" { n++ } END { printf "unreached %d\npart %.1f\n", n, 50 * n / inside }' edges
{ outline to.xy; grep -v expansion edges; } |
    draw icc-6.12-merging-1.png --width 470 --dots 1.4 --colors 222222,c00000,6baed6
awk 'BEGIN { for (y = -1.5; y < 1.5; y += 0.03) for (x = -1; x < 1.6; x += 0.03) print x, y }' >raster
icc-map --coords --outside keep from.xy raster | paste -d ' ' - raster | awk '$1 != "-" { print $(NF - 1), $NF }' >inside
# The image of a small triangle at each point.
awk '{ e = 1e-6; printf "%.17g %.17g\n%.17g %.17g\n%.17g %.17g\n", $1, $2, $1 + e, $2, $1, $2 + e }' inside >corners
collapsed() {
    awk '
        NR % 3 == 1 { x = $1; y = $2 }
        NR % 3 == 2 { ux = $1 - x; uy = $2 - y }
        NR % 3 == 0 { area = (ux * ($2 - y) - uy * ($1 - x)) / 1e-12; n++; flat += area < 1e-4 && area > -1e-4 }
        END { printf "%.0f\n", 100 * flat / n }'
}
$map --outside keep from.xy to.xy corners >images
echo "points $(wc -l <inside)"
echo "collapsed $(collapsed <images)"
echo "finer $(icc-map --method grid --resolution 5 --outside keep from.xy to.xy corners | collapsed)"
{ outline to.xy; awk 'NR % 3 == 1 { print $1, $2, "image"; print "" }' images; } |
    draw icc-6.12-merging-2.png --width 470 --dots 1 --no-legend --colors 222222,08519c
