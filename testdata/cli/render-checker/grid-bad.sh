# errors of a grid are those of its reader
head -n 8 "$DATA/good/grid/square.grid" >cut.grid
render-checker cut.grid; echo $?
printf 'grid 2\n' | render-checker; echo $?
