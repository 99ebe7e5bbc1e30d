# title: L to square
# paper: Chapter 6 shows deformed shapes.
# seen: The six vertices of an L go to four corners of a square and two points of its sides: the reflex corner of 270
#   degrees becomes one of 90. The thesis method: {thesis}. The default
#   method: {ours}.
# picture: The L
# picture: Method grid, the thesis
# picture: Method ray, the default
. "$HERE/lib/icc.sh"
cages
checkers icc-6.2-L-square L-square.from.xy L-square.to.xy 0.001
