deform-mesh --any m.obj g
