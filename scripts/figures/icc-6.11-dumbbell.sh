# title: For comparison: a dumbbell
# paper: Figures 6.9 to 6.11 compare the thesis with other methods. Only our own columns are shown: the thesis method
#   and the default method of icc-map.
# seen: Two squares that are joined by a neck; the neck becomes wider and bends. The thesis method: {thesis}. The default
#   method: {ours}.
# picture: The cage
# picture: Method grid, the thesis
# picture: Method ray, the default
. "$HERE/lib/icc.sh"
cages
render='--scale 60 --square 0.2'
checkers icc-6.11-dumbbell dumbbell.from.xy dumbbell.to.xy 0.004
