printf '%s\n' '0 0' '9 0' '9 9' '0 9' HOLE '2 2' '7 2' '7 7' '2 7' | mkgrid --around - --margin 0 --cell 1 --degree 1
