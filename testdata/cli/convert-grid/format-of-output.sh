# Without --to the name of the output tells the format.
for format in msh vtu obj json; do
    convert-grid -o a.$format $DATA/good/grid/square.grid
    convert-grid --to $format $DATA/good/grid/square.grid | sed 's/ --to [a-z]*//' | cmp - a.$format || exit 9
done
convert-grid --to json -o b.obj $DATA/good/grid/square.grid
head -n 3 b.obj
