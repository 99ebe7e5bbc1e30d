# method grid may fold: then the mesh is refused, else it is as good as another
icc-map --method grid --match arclength --mesh 1 --digits 4 "$DATA/examples/L.xy" "$DATA/examples/square.xy"
icc-map --method grid --mesh 0.01 "$DATA/examples/square.xy" "$DATA/examples/quad.xy"
