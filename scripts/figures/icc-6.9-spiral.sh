# title: For comparison: a spiral unrolled
# paper: Figures 6.9 to 6.11 compare the thesis with other methods. Only our own columns are shown: the thesis method
#   and the default method of icc-map.
# seen: A spiral becomes a straight bar. Its forty parts are shorter inside than outside and of one length in the bar, so
#   the inner end is stretched and the outer end compressed. The thesis method: {thesis}.
#   The default method: {ours}.
# picture: The cage
# picture: Method grid, the thesis
# picture: Method ray, the default
. "$HERE/lib/icc.sh"
cages
render='--scale 33 --square 0.25'
checkers icc-6.9-spiral spiral-bar.from.xy spiral-bar.to.xy 0.006
