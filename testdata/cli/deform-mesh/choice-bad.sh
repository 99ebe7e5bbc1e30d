deform-mesh --normals flip m.obj m.grid
