mkgrid --rect 0,0,4,4 --cells 1x1 --lattice 1 | decles-edit -e 'rotate all about 0 0 by 30' >g
echo '1 1' | deform-mesh --format xy --digits 3 --jacobian - g
