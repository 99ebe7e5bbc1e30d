# Every form of POINTS; each point once, ascending.
printf '1.5 0.5\n3 0.5\n3 3\n' >corner.xy
list-points 17 15-19 v:3 0:2,2,1 @0.4,0.4 ^0.4,0.4 v@0.4,0.4 v^0.6,0.6 box:1,0,1,1 \
    inside:corner.xy "$DATA/good/grid/square.grid" | cut -d ' ' -f 1-3
