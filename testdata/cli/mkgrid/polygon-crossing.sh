printf '%s\n' '0 0' '4 4' '4 0' '0 4' | mkgrid --polygon -
