E=$DATA/examples
for words in '--method circle' '--points 0' '--cell 0' '--cell 1 --points 9' '--digits 18' '--outside x' '--plane yz' '--plane xx' \
    '--inverse --coords' '--coords --model m.obj' '--from-coords --model m.obj' '--model -'; do
    icc-map $words "$E/square.xy" "$E/quad.xy" "$E/points.xy"
    echo "status $?"
done
icc-map "$E/square.xy"
echo "status $?"
