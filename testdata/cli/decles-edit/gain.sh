# An anchor that forces others farther than --max-gain times its own way is refused.
decles-edit --max-gain 0.5 -e 'move v:4 by 0.1 0' "$DATA/good/grid/square.grid"
