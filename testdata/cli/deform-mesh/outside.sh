printf 'v 1 1 0\n\nv 5 1 7\nv 2 2 0\nv -1 0 0\n' >m.obj
deform-mesh m.obj "$DATA/cli/deform-mesh/stretch.grid"
