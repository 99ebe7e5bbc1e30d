mkgrid --model x.obj --cells 4 --cell 1
