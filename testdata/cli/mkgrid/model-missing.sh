mkgrid --model x.obj
