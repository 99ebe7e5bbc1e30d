printf "v %s\n" "0 0 5" "4 0 5" >x.obj
mkgrid --model x.obj --cell 0.0001
