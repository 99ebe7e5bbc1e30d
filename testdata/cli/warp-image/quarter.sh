# a quarter turn of a square, y downwards: clockwise
printf 'P2\n4 4\n255\n 11 12 13 14\n 21 22 23 24\n 31 32 33 34\n 41 42 43 44\n' >image.pgm
mkgrid --image image.pgm --cells 2 | decles-edit -e 'rotate all about 2 2 by 90' - |
    warp-image image.pgm --to pnm | tail -n +4 | od -v -An -tu1 -w4
