# a surface in the plane zy
sed 's/^v \([^ ]*\) \([^ ]*\) 0/v 0 \2 \1/' "$DATA/good/obj-texture/sheared.obj" >zy.obj
render-checker --plane zy --size 10x4 --to pnm zy.obj >zy.pnm
render-checker --size 10x4 --to pnm "$DATA/good/obj-texture/sheared.obj" | cmp - zy.pnm
