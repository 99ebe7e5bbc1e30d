printf 'v 3 1 0\nvn 0.0 1 0\nvt 0 0\nf 1//1 1/1/1 1/1 1 # end\nf -1//-1 \\\n 1/1/1 1\nvn 1 0 0' >m.obj
deform-mesh --normals drop m.obj "$DATA/cli/deform-mesh/stretch.grid"
