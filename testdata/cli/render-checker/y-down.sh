# the same picture, rows the other way round
rows() { tail -n +4 | od -v -An -tx1 -w30; }
render-checker --size 10x4 --to pnm "$DATA/good/obj-texture/sheared.obj" | rows >up
render-checker --size 10x4 --to pnm --y-down "$DATA/good/obj-texture/sheared.obj" | rows | tac | cmp - up
