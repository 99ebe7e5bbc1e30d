printf "v %s\n" "0 0 0" "4 3 2" >x.obj
mkgrid --model x.obj --cell 2 --degree 1 --margin 1 --depth 0,4 --plane yz
