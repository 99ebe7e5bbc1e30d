# title: Integral curve coordinates
# paper: Chapter 3: a point is named by the place where its integral line meets the cage, and by how far
#   along the line it lies; the line of the same name in the deformed cage has its image at the same part.
# seen: Lines from every second vertex of the cage, and the points at 1/4, 1/2 and 3/4 of the way from the
#   maximum (0) to the cage (1). The dot, (0.9, 0.25), has side k, lambda and t = {point} by the default
#   method and comes to ({image}). Lines of the thesis' function run together before they reach the
#   maximum, those of the default method never do.
# picture: Method ray, the cage and the names of its points
# picture: Method ray, the same names in the deformed cage
# picture: Method grid, the thesis, in the cage
# picture: Method grid, the same names in the deformed cage
. "$HERE/lib/icc.sh"
legs 0 >from.xy
legs 1 >to.xy
echo '0.9 0.25 point' >point
icc-map --coords --digits 4 from.xy point | sed 's/^\(.*\) point/point \1/'
icc-map --digits 4 from.xy to.xy point | sed 's/^\(.*\) point/image \1/'
awk 'BEGIN {
    for (k = 0; k < 54; k += 2) {
        for (t = 0; t <= 40; t++) printf "%d 0 %.9g line\n", k, t / 40
        print ""
    }
    for (t = 1; t <= 3; t++) {
        for (k = 0; k <= 54; k++) for (i = 0; i < 4 && (k < 54 || !i); i++)
            printf "%d %.9g %.9g level\n", k % 54, i / 4, t / 4
        print ""
    }
}' >names
n=0
for method in ray grid; do
    for cage in from to; do
        {
            outline $cage.xy
            icc-map --method $method --from-coords from.xy $cage.xy names
            echo
            icc-map --method $method from.xy $cage.xy point
        } >lines
        n=$((n + 1))
        draw icc-3.1-coordinates-$n.png <lines --width 400 --dots 4 --colors 222222,8ab4d8,d55e00,c00000
    done
done
