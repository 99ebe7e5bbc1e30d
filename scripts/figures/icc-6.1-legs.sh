# title: A shape of three legs, bent
# paper: Chapter 6 shows deformed shapes. Its timing (Table 6.1) is for a cage of 54 vertices.
# seen: A cage of 54 vertices with three legs. By the thesis method the map is torn along ridges where lines
#   merge, and pieces of the pattern are missing: {thesis}
#   (purple: turned over). By the default method: {ours}.
# picture: The cage
# picture: Method grid, the thesis
# picture: Method ray, the default
. "$HERE/lib/icc.sh"
legs 0 >from.xy
legs 1 >to.xy
checkers icc-6.1-legs from.xy to.xy 0.001
