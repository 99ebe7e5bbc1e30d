# title: For comparison: a comb
# paper: Figures 6.9 to 6.11 compare the thesis with other methods. Only our own columns are shown: the thesis method
#   and the default method of icc-map.
# seen: Five teeth are bent aside. The thesis method: {thesis}. The default
#   method: {ours}.
# picture: The cage
# picture: Method grid, the thesis
# picture: Method ray, the default
. "$HERE/lib/icc.sh"
cages
render='--scale 32 --square 0.25'
checkers icc-6.10-comb comb.from.xy comb.to.xy 0.02
