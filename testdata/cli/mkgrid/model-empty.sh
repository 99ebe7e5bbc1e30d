: >x.obj
mkgrid --model x.obj
