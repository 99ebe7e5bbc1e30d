# an error, or an image whose pixels are wrong; never a word of the decoder's own
mkgrid --rect 0,0,32,32 --cells 1x1 --degree 1 >square.grid
for file in "$DATA"/hostile/images/*; do
    timeout 10 warp-image --to pnm "$file" square.grid 2>&1 >picture
    echo "${file##*/}: $?, $(head -n 2 picture | tail -n 1)"
done
