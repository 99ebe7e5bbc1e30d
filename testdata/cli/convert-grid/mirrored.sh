# In the plane zy the model's frame mirrors the grid's: the corners 1 and 2 change places.
mkgrid --rect 0,0,2,1 --cells 1x1 --degree 2 --depth 0,1 | sed '/^degree/a plane zy' >mirrored.grid
for format in msh vtu; do
    convert-grid --to $format mirrored.grid | awk '
        /^.Elements/ || /connectivity/ { on = 1 } /^.End/ || /<.DataArray/ { on = 0 } on'
done
convert-grid --to obj --steps 1 mirrored.grid | grep -v '^vt'
