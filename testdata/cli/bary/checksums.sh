# by gzip, which prints the CRC-32 of what it packs, and by od
mkgrid --rect 0,0,3,2 --cells 3x2 --depth -1,1 >g
printf 'v 1 0.5 -1\nv 2 -0 0.1\n' >m.obj
crc() { gzip -c | tail -c 8 | head -c 4 | od -A n -t u1 | awk '{ printf "%02x%02x%02x%02x\n", $4, $3, $2, $1 }'; }
{
    echo "domain $(sed '1,/^degree/d; /^points/,$d' g | crc)"
    # 1 0.5 -1 2 -0 0.1
    echo "model $(printf '\0\0\0\0\0\0\360\77\0\0\0\0\0\0\340\77\0\0\0\0\0\0\360\277\0\0\0\0\0\0\0\100\0\0\0\0\0\0\0\200\232\231\231\231\231\231\271\77' | crc)"
} >expected
bary m.obj g | sed -n '/^domain/,/^model/p' | diff - expected
