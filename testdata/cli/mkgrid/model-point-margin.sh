echo "v 1 2 3" >x.obj
mkgrid --model x.obj --margin 1 --cells 2 --degree 1
