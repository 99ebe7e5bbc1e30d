deform-mesh nothing.obj "$DATA/cli/deform-mesh/stretch.grid"
