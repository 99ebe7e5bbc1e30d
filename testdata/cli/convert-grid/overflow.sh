# Control points that are doubles, and an image that is none.
mkgrid --rect 0,0,1,1 --cells 1x1 --degree 2 >a.grid
sed '/^points/,$ s/^[0-9.]* /-1.7e308 /; 10,$ s/^\(-1.7e308\) 0.5/1.7e308 0.5/' a.grid |
    sed 's/^lattice .*/lattice 1.5258789e-05 1.7e308 0/' | convert-grid --to obj --steps 4
