# title: An image in a real outline
# paper: Chapter 6 shows deformed shapes.
# seen: Frame 254 of a video of a crawling C. elegans (WormPose sample data, BSD-3), inside the outline of the worm,
#   which was measured in the video and has 102 vertices; brought to the outline in frame 193. The
#   thesis method: {thesis}. The default method: {ours}.
# picture: Frame 254 in its outline
# picture: Method grid, the thesis
# picture: Method ray, the default
. "$HERE/lib/icc.sh"
worms=$DATA/shapes2d/worm_outline_pairs
render="--scale 7 --y-down --background ffffff --texture $DATA/images/worm-254.png"
checkers icc-6.8-worm $worms/frame00254_outline102.dat $worms/frame00193_outline102.dat 0.4
