# The thickness of the prisms is certified too.
check-grid --bound 0.001 <"$DATA/good/grid/prism.grid"
mkgrid --rect 0,0,2,1 --cells 2x1 --depth 0,1 |
    decles-edit -e 'raise top v@1,0 by -1.5 reach 3' - | check-grid | grep -e thickness -e prisms -e holds
