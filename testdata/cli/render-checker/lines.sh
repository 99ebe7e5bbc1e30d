# the quadrilateral's diagonal is no line of the mesh
render-checker --mesh-lines --squares 1 --colors white,white --scale 2 --to pnm "$DATA/good/obj-texture/sheared.obj" |
    tail -n +4 | od -v -An -tu1 -w60 | awk '{ for (i = 1; i <= NF; i += 3) printf "%4d", $i; print "" }'
