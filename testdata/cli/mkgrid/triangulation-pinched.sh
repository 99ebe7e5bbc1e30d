printf '%s\n' 'v 0 0 0' 'v 2 0 0' 'v 2 2 0' 'v -2 0 0' 'v -2 -2 0' 'f 1 2 3' 'f 1 4 5' >q.obj
mkgrid --triangulation q.obj
