# the image that the grid was made for, moved as warp-image does it
mkgrid --image "$DATA/images/worm.pgm" --cells 4 | decles-edit -e 'rotate v@31,29 about 31 29 by 20 reach 9' - >bent.grid
render-checker --texture "$DATA/images/worm.pgm" --y-down --size 63x59 --antialias 1 --to pnm bent.grid >checker.pnm
warp-image --background 255 --to pnm "$DATA/images/worm.pgm" bent.grid >warp.pnm
tail -n +4 warp.pnm | od -v -An -tu1 -w1 >warp
tail -n +4 checker.pnm | od -v -An -tu1 -w3 |
    paste -d ' ' - warp | awk '{ d = $1 - $4; n++; if (d > 24 || d < -24) far++ } END { print n, far < n / 50 ? "alike" : far }'
