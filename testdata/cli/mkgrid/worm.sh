mkgrid --model "$DATA/models/virtual_worm_cuticle.obj" --plane zy --cells 40 --verbose -o worm.grid
head -n 6 worm.grid
cksum worm.grid | cut -d " " -f 1,2
