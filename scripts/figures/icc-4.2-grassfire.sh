# title: The maximum: where a fire that starts all around ends
# paper: Chapter 4: the maximum is chosen by a grassfire; vertices burn step by step from the outside in,
#   and one of those that burn last is taken.
# seen: The step in which each vertex burns, of {steps}. In legs, fire from both sides meets in ridges; the
#   last vertices to burn are in the middle of what is widest. The thesis does not say which of them is
#   taken; here it is the one nearest to the middle of them. In the bent cage it is found just as well.
# picture: The steps on a coarse grid
# picture: On a finer grid, in the bent cage
. "$HERE/lib/icc.sh"
legs 0 >from.xy
legs 1 >to.xy
icc-map --method grid --cell 0.14 --show grassfire from.xy >fire
awk 'NF && $3 > n { n = $3 } END { print "steps", n }' fire
{ outline from.xy; cat fire; } | draw icc-4.2-grassfire-1.png --width 470 --squares 0.14 --dot-labels --colors 222222
{ outline to.xy; icc-map --method grid --cell 0.04 --show grassfire to.xy; } |
    draw icc-4.2-grassfire-2.png --width 470 --squares 0.04 --colors 222222
