# title: Where a deformation folds, and an edit that stops before
# paper: Not known to us. The report's section 3.4 is about maps that do not fold: det grad phi > 0.
# picture: an edit that folds (magenta)
# picture: with --no-fold --limit: as much of it as keeps det grad phi > 0.2
# seen: One corner is dragged far. Colours tell by how much areas grow. In the first picture check-grid
#   finds a place where the determinant is {folded} and answers that it {first}; in the second decles-edit
#   carried out {part} of the move, and the map is {second}: at least {least} everywhere.
mkgrid --rect 0,0,6,4 --cells 6x4 -o flat.grid
edit='move v^3,2 by 1.6 0.8 reach 7'
decles-edit -e "$edit" flat.grid -o folded.grid
decles-edit --verbose --no-fold=0.2 --limit -e "$edit" flat.grid -o limited.grid 2>messages
cat messages
awk '{ for (i = 1; i < NF; i++) if ($i == "limited") print "part", $(i + 2) }' messages
check-grid folded.grid 2>/dev/null >report || true
awk '/^local:/ { print "first", $2 } /^det-lower:/ { print "folded", $2 }' report
check-grid --bound 1e-4 limited.grid >report
awk '/^local:/ { print "second", $2 } /^det-lower:/ { print "least", $2 }' report
draw-grid --layers jacobian,triangles,outline --width 430 -o decles14-09-folds-1.png folded.grid
draw-grid --layers jacobian,triangles,outline --width 430 -o decles14-09-folds-2.png limited.grid
