mkgrid --rect 0,0,4,4 --cells 1x1 >g
echo '# nothing' >m.obj
bary m.obj g
