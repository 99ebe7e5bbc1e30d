printf '%s\n' '0 0' '8 0' '8 6' '0 6' HOLE '2 2' '4 2' '4 4' '2 4' >p.xy
mkgrid --polygon p.xy --lattice 0.5 --degree 1
