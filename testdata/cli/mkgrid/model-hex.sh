printf "v %s\n" "0 0 0" "4 0 0" "4 3 0" >x.obj
echo "l 1 2 3" >>x.obj
mkgrid --model - --cells 4 --degree 1 --pattern hex --flat --margin 0.25 --verbose <x.obj
