deform-mesh - -
