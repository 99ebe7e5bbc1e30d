printf 'v 0.123456789 1.5 100000.25\nvn 0.1 0.2 0.3\nf 1//1 1//1 1//1\n' | deform-mesh --digits 4 - "$DATA/cli/deform-mesh/stretch.grid"
