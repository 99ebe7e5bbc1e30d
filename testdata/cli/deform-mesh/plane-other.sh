printf 'v 1 2 4\n' | deform-mesh --plane xy - "$DATA/cli/deform-mesh/lifted.grid"
