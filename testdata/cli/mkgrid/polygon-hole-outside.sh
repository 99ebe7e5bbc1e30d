printf '%s\n' '0 0' '4 0' '4 4' HOLE '5 5' '6 5' '6 6' | mkgrid --polygon -
