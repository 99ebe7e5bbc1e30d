printf 'v 1 2 4\n' | bary --plane xy - "$DATA/cli/deform-mesh/lifted.grid"
