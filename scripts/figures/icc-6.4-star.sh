# title: A decagon to a star
# paper: The thesis deforms a shape to one with sharp tips, a star, for example.
# seen: At a sharp tip a vertex of the grid may be inside and none that is beside it. Even the finest grid that icc-map
#   tries of its own accord is refused: {refused}.
#   So the test must be a warning only: {thesis}. The default method:
#   {ours}.
# picture: The decagon
# picture: Method grid, the thesis
# picture: Method ray, the default
. "$HERE/lib/icc.sh"
regular 5 1 >from.xy
regular 5 0.3 >to.xy
if icc-map --method grid --show grid to.xy 2>refusal; then exit 1; fi
sed 's/.*resolution: /refused /' refusal
checkers icc-6.4-star from.xy to.xy 0.001 --points 1460 --resolution-check warn
