# Edges and corners of the grid belong to it; a hair further does not.
printf 'v 0 0 0\nv 4 4 0\nv 4 0 0\nv 2 2 0\nv 4 1.25 0\nv 1 0 0\n' | deform-mesh - "$DATA/cli/deform-mesh/stretch.grid"
printf 'v 4.000000000000001 1 0\n' | deform-mesh - "$DATA/cli/deform-mesh/stretch.grid"
