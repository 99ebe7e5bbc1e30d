printf '%s\n' 'v 0 0 0' 'v 4 0 0' 'v 4 4 0' 'v 0 4 0' 'f 1 2 3 4' >q.obj
mkgrid --triangulation q.obj
