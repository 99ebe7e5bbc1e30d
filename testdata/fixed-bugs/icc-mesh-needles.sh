# Parts of a cage that are 1e-15 wide: to triangulate them well took more than 2,000,000 triangles,
# however large the area that was asked for, so there was no mesh; the overlay needs few.
printf '%s\n' '1e-06 2.999999999999' '0 2' '1.999999999 -1e-09' '1e-06 1.999999999999' \
    '2.000000001 3e-16' '2.9999999999999996 1.000000000001' >needles.xy
printf '%s\n' '0.999999 -1e-15' '2.999999999 2.000000000000001' '1.000000000001 2' \
    '1.000000000000001 2.000000000000001' '1e-15 3.000001' '3e-16 1e-09' >others.xy
icc-map --mesh 1 --verbose needles.xy others.xy | LC_ALL=C awk '
    $1 == "v" { n++; x[n] = $2; y[n] = $3 }
    $1 == "f" {
        split($2, a, "/"); split($3, b, "/"); split($4, c, "/")
        i = a[1]; j = b[1]; k = c[1]
        area += ((x[j] - x[i]) * (y[k] - y[i]) - (y[j] - y[i]) * (x[k] - x[i])) / 2
        triangles++
    }
    END { printf "%d triangles, area %.9f\n", triangles, area }'
icc-map --mesh 1 --method grid --resolution-check warn needles.xy others.xy
