# SPDX-License-Identifier: GPL-3.0-or-later
# A move of all points by 1e305 was refused as a conflict of the anchors, since sums of conditions
# became nan; so were huge coordinates of the grid itself, as not C1. The message is now that positions
# leave the range of numbers. Without conditions the range is that of doubles.
mkgrid --rect 0,0,4,4 --cells 2x2 >rest.grid
decles-edit --continuity 0 -e 'move all by 1e305 0' rest.grid >far.grid || exit
decles-edit -e 'move v:4 to 1 1' far.grid
decles-edit -e 'move all by 1e305 0' rest.grid
