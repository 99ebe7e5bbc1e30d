deform-mesh
