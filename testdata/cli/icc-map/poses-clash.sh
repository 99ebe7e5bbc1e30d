printf 'a/x.xy\nb/y.xy\nc/x.xy\n' >list
icc-map --poses list --out-dir . "$DATA/examples/cage.xy" "$DATA/examples/outline.xy"
