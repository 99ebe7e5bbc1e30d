# title: Bernstein polynomials of degree 5 over a triangle
# paper: Not known to us. The splines are written in Bernstein polynomials 5!/(i! j! k!) b0^i b1^j b2^k of
#   the barycentric coordinates.
# picture: i,j,k = 5,0,0, at a corner
# picture: 3,2,0, on a side
# picture: 2,2,1, inside
# seen: The graphs over one triangle of three of the {count} polynomials, each made as a spline that has the
#   coefficient 1 there and 0 elsewhere (times 3). The greatest values are {height-1}, {height-2} and
#   {height-3}; all are positive inside and their sum is 1.
printf '0 0\n4 0\n1 3.5\n' >one.xy
mkgrid --polygon one.xy --max-area 100 --depth 0,0.001 -o flat.grid
echo "count $(list-points flat.grid | wc -l)"
n=0
for index in 5,0,0 3,2,0 2,2,1; do
    n=$((n + 1))
    decles-edit -e "raise top 0:$index by 3" flat.grid -o graph.grid
    convert-grid --to obj --steps 50 graph.grid |
        awk -v n=$n '$1 == "v" && $4 > top { top = $4 } END { printf "height-%d %.4f\n", n, (top - 0.001) / 3 }'
    render-model --grid graph.grid --no-model --layers glass,triangles,net,points --controls top \
        --view -20,32 --size 320x320 -o decles11-02-bernstein-$n.png
done
