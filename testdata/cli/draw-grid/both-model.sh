# Two panels of one scale; the model's silhouette before and after.
printf 'v 0.5 0.25 0\nv 1.5 0.25 0\nv 1 0.75 0\nv 0.5 0.75 9\nf 1 2 3\nl 1 4\n' >m.obj
mkgrid --rect 0,0,2,1 --cells 1x1 --degree 5 | decles-edit -e 'move all by 1 0' |
    draw-grid --to svg --width 200 --side both --model m.obj
