printf "v %s\n" "0 0 5" "4 0 5" "4 3 5" >x.obj
mkgrid --model x.obj --depth 0,4.5
