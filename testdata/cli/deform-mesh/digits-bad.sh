deform-mesh --digits 18 m.obj m.grid
