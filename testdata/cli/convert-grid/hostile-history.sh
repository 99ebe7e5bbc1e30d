# What JSON and XML cannot hold: quotes, control characters, bytes that are no UTF-8, "?>", "-->".
sed 1q $DATA/good/grid/square.grid >a.grid
printf '# "quoted" back\\slash tab\tescape\033 latin \344 utf \303\244 \342\202\254 ?> ?\033> --> ]]> <&>\n' >>a.grid
sed 1d $DATA/good/grid/square.grid >>a.grid
convert-grid --to json a.grid | sed -n 5,6p
convert-grid --to vtu a.grid | sed -n 2,3p
