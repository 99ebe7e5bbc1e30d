echo "v 1 2 3" >x.obj
mkgrid --model x.obj
