printf "v %s\n" "0 0 0" "4 0 0" "4 3 1" "0 3 1" >x.obj
echo "f 1 2 3 4" >>x.obj
mkgrid --model x.obj --cells 4 --degree 1 --verbose
