mkgrid --image no.png --cells 4
