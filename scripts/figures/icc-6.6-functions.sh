# title: Other functions: their lines
# paper: Section 6.5: instead of the cousin tree's values, the number of steps to the maximum (Manhattan), a
#   harmonic and a biharmonic function.
# seen: Lines from 100 places on the cage, by each of the functions on the same grid. Manhattan's lines are
#   diagonal, those of the cousin tree nearly so, and they merge on the axes through the maximum. Harmonic and
#   biharmonic lines are smooth curves that come close to each other in the legs, and merge late. On average,
#   the part of a line that it shares with another one is {cousin} % with the cousin tree, {manhattan} % with
#   Manhattan, {harmonic} % with the harmonic and {biharmonic} % with the biharmonic function.
# picture: The cousin tree
# picture: Manhattan
# picture: Harmonic
# picture: Biharmonic
. "$HERE/lib/icc.sh"
legs 0.6 >legs.xy
n=0
for f in cousin manhattan harmonic biharmonic; do
    n=$((n + 1))
    icc-map --method grid --resolution 2 --function $f --lines 100 legs.xy >lines
    { outline legs.xy; awk 'NF { $3 = "line" } 1' lines; } |
        draw icc-6.6-functions-$n.png --width 400 --no-legend --colors 222222,6baed6
    # Lines that have met in a point are one from there on.
    awk -v name=$f '
        NR == FNR { lines[$1, $2]++; next }
        !NF { if (whole) { sum += shared / whole; n++ } met = whole = shared = at = 0; next }
        at {
            step = sqrt(($1 - x)^2 + ($2 - y)^2)
            whole += step
            if (met) shared += step
        }
        { x = $1; y = $2; at = 1; if (lines[x, y] > 1) met = 1 }
        END { if (whole) { sum += shared / whole; n++ } printf "%s %.0f\n", name, 100 * sum / n }' lines lines
done
