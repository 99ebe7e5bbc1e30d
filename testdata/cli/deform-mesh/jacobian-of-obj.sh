deform-mesh --jacobian m.obj g
