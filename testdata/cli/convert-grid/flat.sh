mkgrid --rect 0,0,1,1 --cells 1x1 --degree 1 --depth 0,1 >deep.grid
mkgrid --rect 0,0,1,1 --cells 1x1 --degree 1 >flat.grid
for format in msh vtu obj json; do
    convert-grid --to $format --flat deep.grid | grep -v 'convert-grid\|mkgrid' >deep
    convert-grid --to $format flat.grid | grep -v 'convert-grid\|mkgrid' >flat
    test -s flat && cmp deep flat || exit 9
done
