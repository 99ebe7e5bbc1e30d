# title: Other functions: their maps
# paper: Section 6.5: deformations with other functions.
# seen: The same deformation as in figure 6.1, on a finer grid. The harmonic and the biharmonic function, whose lines
#   merge late, collapse little; but some triangles are turned over. Cousin tree: {cousin}; Manhattan:
#   {manhattan}; harmonic: {harmonic}; biharmonic: {biharmonic}.
# picture: cousin
# picture: manhattan
# picture: harmonic
# picture: biharmonic
. "$HERE/lib/icc.sh"
legs 0 >from.xy
legs 1 >to.xy
icc-map --mesh 0.001 from.xy from.xy >rest.obj
n=0
for f in cousin manhattan harmonic biharmonic; do
    n=$((n + 1))
    icc-map --method grid --resolution 3 --function $f --model rest.obj from.xy to.xy >$f.obj
    echo "$f $(folds $f.obj)"
    render-checker --size 400x360 --squares 20 --mark-folds -o icc-6.7-functions-$n.png $f.obj
done
