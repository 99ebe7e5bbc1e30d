printf '0 0\r\n1 0\r\n1 1' | icc-map $DATA/examples/square.xy $DATA/examples/quad.xy - | od -c
