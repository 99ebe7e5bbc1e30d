mkgrid --model "$DATA/models/virtual_worm_cuticle_red75.obj" --plane zy --pattern hex --verbose -o worm.grid
head -n 6 worm.grid
cksum worm.grid | cut -d " " -f 1,2
