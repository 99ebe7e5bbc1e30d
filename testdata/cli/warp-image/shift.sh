# three pixels to the right and one up, on a dark ground; and back
printf 'P2\n6 4\n255\n 11 12 13 14 15 16\n 21 22 23 24 25 26\n 31 32 33 34 35 36\n 41 42 43 44 45 46\n' >image.pgm
pixels() { tail -n +4 | od -v -An -tu1 -w6; }
mkgrid --image image.pgm --cells 2 | decles-edit -e 'move all by 3 -1' - >shift.grid
warp-image image.pgm shift.grid --to pnm | pixels
warp-image image.pgm shift.grid --to pnm --background 99 --inverse | pixels
