printf '%s\n' 'v 0 0 0' 'v 4 0 0' 'v 2 3 0' 'v 2 0 0' 'v 0 -3 0' 'v 4 -3 0' 'f 1 2 3' 'f 4 5 6' >q.obj
mkgrid --triangulation q.obj
