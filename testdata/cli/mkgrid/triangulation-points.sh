printf '%s\n' '0 0 a' '4 0 b' '4 4' '0 4' '1 2' >q.xy
mkgrid --triangulation q.xy --degree 1
