printf '%s\n' '0 0' '8 8' '8 0' '0 8' | mkgrid --around - --margin 0.1 --cell 2 --degree 1 --depth 0,1
