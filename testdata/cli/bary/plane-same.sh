printf 'v 1 2 4\n' | bary --plane zy - "$DATA/cli/deform-mesh/lifted.grid"
