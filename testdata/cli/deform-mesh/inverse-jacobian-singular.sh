# X = 0: there are preimages, but no derivative.
mkgrid --rect 0,0,1,1 --cells 1x1 --lattice 1 --degree 2 | awk '
    /^points/ { print; p = 1; next }
    p && NF == 2 { print 0, $2; next }
    { print }' >g
echo '0 0.5' >p.xy
deform-mesh --inverse --any p.xy g | LC_ALL=C awk '$1 >= 0 && $1 <= 1 && $2 == 0.5 { print "a preimage" }' >&2
deform-mesh --inverse --any --jacobian p.xy g
