deform-mesh --bary - m.obj
