# The operands in the wrong order.
deform-mesh "$DATA/cli/deform-mesh/stretch.grid" "$DATA/good/obj/square.obj"
