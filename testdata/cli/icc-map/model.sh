# x and y of the vertices, everything else as it is.
printf '# a model\nv 0.5 0.25 7\nv 1 0.5 3 0.5\nvt 0 0\nf 1 2 1\n' >m.obj
icc-map --model m.obj "$DATA/examples/square.xy" "$DATA/examples/quad.xy"
icc-map --model - --plane yz "$DATA/examples/square.xy" "$DATA/examples/quad.xy" <<'OBJ'
v 7 0.5 0.25
OBJ
