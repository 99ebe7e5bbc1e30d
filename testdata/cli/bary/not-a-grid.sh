echo 'v 1 1 1' >m.obj
bary m.obj m.obj
