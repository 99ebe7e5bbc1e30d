# Grid x is model z, grid y is model y, depth is model x: the top rises with z.
printf 'v 1 2 4\nv -1 2 4\nv 0 1 2\nvn 1 0 0\nf 1//1 2//1 3//1\n' | deform-mesh --plane zy - "$DATA/cli/deform-mesh/lifted.grid"
