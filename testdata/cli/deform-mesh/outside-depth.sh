# Inside the triangles, but not between the planes of the grid; x is the depth.
printf 'v 1 1 1\nv 1.5 1 1\n' >m.obj
deform-mesh m.obj "$DATA/cli/deform-mesh/lifted.grid"
