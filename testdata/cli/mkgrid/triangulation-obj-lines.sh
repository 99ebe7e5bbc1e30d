printf '%s\n' 'v 0 0 0' 'v 4 0 0' 'l 1 2' >q.obj
mkgrid --triangulation q.obj
