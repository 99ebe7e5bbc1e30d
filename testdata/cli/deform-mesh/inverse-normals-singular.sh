# X = 0: normals are kept, with a warning.
mkgrid --rect 0,0,1,1 --cells 1x1 --lattice 1 --degree 2 | awk '
    /^points/ { print; p = 1; next }
    p && NF == 2 { print 0, $2; next }
    { print }' >g
printf 'v 0 0.5 7\nv 0 0.25 7\nv 0 1 7\nvn 1 1 0\nf 1//1 2//1 3//1\n' >m.obj
deform-mesh --inverse --any m.obj g | grep -v '^v '
