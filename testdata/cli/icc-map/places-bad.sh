# Lines that are no coordinates.
E=$DATA/examples
for line in '4 0.5 0.5' '0 1.5 0.5' '0 -0.1 0.5' '0 0.5 1.5' '0 0.5' 'x 0 0' '- 1' '0.5 0 0' \
    '-1 0 0' '99999999999999999999 0.5 0.5' '0x1 0 0' '3/4 0 0' ''; do
    echo "$line" | icc-map --from-coords "$E/square.xy" "$E/quad.xy"
    echo "status $?"
done
