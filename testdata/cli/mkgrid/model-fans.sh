# two loose points, whose squares would meet at a corner only
printf "v %s\n" "0 0 0" "3 0 0" "0 3 0" "3 3 0" "1.2 1.2 0" "1.8 1.8 0" >x.obj
mkgrid --model x.obj --cell 1 --degree 1 --flat --margin 0.01 --verbose
