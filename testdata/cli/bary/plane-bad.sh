printf 'v 1 2 4\n' | bary --plane xx - "$DATA/cli/deform-mesh/lifted.grid"
