# degree, pose and history are no part of the domain; a step is
echo '1 1' >p.xy
mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 1 --degree 1 >a
mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 1 --degree 5 | decles-edit -e 'move @1,1 by 1 0' >b
mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 0.5 >c
for g in a b c; do bary p.xy $g | grep domain; done
