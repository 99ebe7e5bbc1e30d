# The file is replaced only by a whole one.
printf 'v 1 1 0\n' >m.obj
printf 'v 9 9 9\n' >outside.obj
deform-mesh -o m.obj m.obj "$DATA/cli/deform-mesh/stretch.grid"
deform-mesh -o m.obj outside.obj "$DATA/cli/deform-mesh/stretch.grid" || echo "status $?"
cat m.obj
ls
