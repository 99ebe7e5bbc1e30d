# A soft move of one corner.
decles-edit -e 'move v:4 by 0.1 0.05 reach 2' --digits 6 "$DATA/good/grid/square.grid"
