# a grid of an image is flat, and edits count in pixels, y down
mkgrid --image "$DATA/images/worm.png" --cells 2 | decles-edit -e 'move v@32,30 by 1.5 -2' | list-points v:4
