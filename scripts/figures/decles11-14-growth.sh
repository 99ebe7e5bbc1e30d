# title: Growth
# paper: Not known to us. Growth is named among the uses.
# picture: at rest
# picture: the middle of the body grown by 1.6 along and across, and in depth
# seen: A part of the worm is scaled about its middle, its neighbourhood softly, and the tops of its prisms
#   rise and their bottoms sink, as in a gravid worm. The prisms' volume is {volume-ratio} of what it was; the map
#   is one-to-one ({one-to-one}).
worm=$DATA/models/virtual_worm_cuticle.obj
mkgrid --model "$worm" --plane zy --cells 24 --margin 0.05 -o rest.grid
printf 'edits 1\nscale box:-0.6,-2,0.9,2 about 0.1 -0.05 by 1.6 within 1.6\nraise top box:-0.6,-2,0.9,2 by 0.25 within 1.6\nraise bottom box:-0.6,-2,0.9,2 by -0.25 within 1.6\n' >grow.edits
decles-edit grow.edits rest.grid -o grown.grid
check-grid grown.grid | grep -E '^(local|volume-ratio|one-to-one)'
deform-mesh "$worm" grown.grid -o grown.obj
render-model --plane zy --view -25,30 --size 480x220 -o decles11-14-growth-1.png "$worm"
render-model --plane zy --view -25,30 --size 480x260 -o decles11-14-growth-2.png grown.obj
