# the box in the middle of a picture of another shape; 800 pixels; pixels a unit
for options in '--size 7x7' '' '--scale 0.55' '--scale 3'; do
    render-checker $options --to pnm "$DATA/good/obj-texture/sheared.obj" | head -n 2 | tail -n 1
done
