mkgrid --model x.obj --cells 4x4
