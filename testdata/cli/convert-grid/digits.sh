mkgrid --rect 0,0,1,1 --cells 1x1 --degree 3 >a.grid
convert-grid --to obj --steps 3 --digits 2 a.grid | grep '^v'
convert-grid --to json --digits 3 a.grid | sed -n '/"nominal"/,$p'
