mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 1 | decles-edit -e 'move all by 1 0.5' >g
printf '# a list\n1 1 one   1e3 # comment\n\n\t2.50  3\r\n HOLE \n0 4,x\n0 4 x' >p.xy
sed -i 's/^0 4,x/+1. 01/' p.xy
deform-mesh p.xy g
echo .
