# refused: what ends early, lies about lengths, is no image. Taken: what is wrong with the pixels only
for file in "$DATA"/hostile/images/*; do
    timeout 10 mkgrid --image "$file" --cells 1x1 --degree 1 2>&1 >grid
    status=$?
    echo "${file##*/}: $status, $(wc -l <grid) lines"
    rm grid
done
