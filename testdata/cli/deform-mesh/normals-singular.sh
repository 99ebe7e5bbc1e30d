# Where the Jacobian is singular the normal stays, and stderr says so.
printf 'v 3 1 0\nv 1 3 0\nv 2 2 1\nvn 0.0 1 0\nf 1//1 2//1 3//1\n' >m.obj
deform-mesh m.obj "$DATA/cli/deform-mesh/flat.grid"
