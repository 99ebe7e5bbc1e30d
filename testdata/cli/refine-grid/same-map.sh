printf "edits 1\nmove v:4 by 0.3 0.2 reach 4\n" >e
mkgrid --rect 0,0,2,2 --cells 2x2 | decles-edit e >coarse.grid
LC_ALL=C awk "BEGIN { for (i = 0; i <= 8; i++) for (j = 0; j <= 8; j++) print \"v\", i / 4, j / 4, 0 }" >points.obj
refine-grid --times 2 coarse.grid >fine.grid
deform-mesh --digits 14 points.obj coarse.grid >a.obj
deform-mesh --digits 14 points.obj fine.grid >b.obj
cmp a.obj b.obj && echo same
