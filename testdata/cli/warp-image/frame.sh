# a frame with y upwards and two units a pixel: the same shift is half as many pixels, the other way
printf 'P2\n6 4\n255\n 11 12 13 14 15 16\n 21 22 23 24 25 26\n 31 32 33 34 35 36\n 41 42 43 44 45 46\n' >image.pgm
mkgrid --image image.pgm --frame 0,8,12,0 --cells 2 | decles-edit -e 'move all by 4 -2' - |
    warp-image image.pgm --frame 0,8,12,0 --to pnm | tail -n +4 | od -v -An -tu1 -w6
