printf '%s\n' '0 0' '8 0' '8 6' '0 6' HOLE '2 2' '4 2' '4 4' '2 4' >p.xy
mkgrid --polygon p.xy --max-area 4 --degree 2 --verbose
