# title: A square to a quadrilateral with sharp corners
# paper: Chapter 6 shows deformed shapes.
# seen: A square becomes a quadrilateral that is not convex and has two sharp corners. The thesis method:
#   {thesis}. The default method: {ours}.
# picture: The square
# picture: Method grid, the thesis
# picture: Method ray, the default
. "$HERE/lib/icc.sh"
cages
render='--size 310x150 --squares 20'
checkers icc-6.3-sharp square-sharp.from.xy square-sharp.to.xy 0.0006
