# title: More postures of the same worm
# paper: The deformed model of an organism over its image. Which postures it has is not known to us.
# picture: frame 303 of the video
# picture: overlap {overlap-303}
# picture: frame 449
# picture: overlap {overlap-449}
# seen: One model at rest and one script (posture.awk, see figure 2), two other frames of the same worm: the
#   silhouettes and the outlines measured in the video overlap by {overlap-303} and {overlap-449}; the
#   verdicts of check-grid are {local-303} and {local-449}.
worm=$DATA/models/virtual_worm_cuticle_red75.obj
mkgrid --model "$worm" --flat --plane zy --cells 40 --margin 0.15 -o rest.grid
n=0
for frame in 303,77,85 449,79,86; do
    size=${frame#*,}
    frame=${frame%%,*}
    sh -e "$HERE/lib/posture.sh" $frame "$worm" rest.grid bent.grid | sed "s/^overlap/overlap-$frame/"
    check-grid bent.grid | sed -n "s/^local:/local-$frame/p"
    draw-grid --no-grid --image "$DATA/images/worm-$frame.png" --frame "0,0,${size%,*},-${size#*,}" --width 340 \
        -o decles14-15-postures-$((n += 1)).png
    draw-grid --model "$worm" --layers outline,triangles --lines outline.lines --image "$DATA/images/worm-$frame.png" \
        --frame "0,0,${size%,*},-${size#*,}" --width 380 -o decles14-15-postures-$((n += 1)).png bent.grid
done
