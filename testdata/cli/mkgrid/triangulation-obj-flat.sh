printf '%s\n' 'v 0 5 0' 'v 4 5 0' 'v 4 5 4' 'v 0 5 4' 'v 9 9 9' 'f 1 2 3' 'f 1 3 4' >q.obj
mkgrid --triangulation q.obj
