# The format follows the name or --to; PDF and PNG are the same bytes again.
mkgrid --rect 0,0,2,1 --cells 1x1 -o a.grid
for name in a.png a.pdf a.SVG b.pdf b.png; do draw-grid -o $name a.grid; done
draw-grid --to pdf -o a.picture a.grid
draw-grid a.grid >c.png
head -c 5 a.SVG
head -c 5 a.pdf | cut -c 1-5
od -An -c -N 4 a.png
cmp a.pdf b.pdf && cmp a.pdf a.picture && cmp a.png b.png && cmp a.png c.png && grep -c CreationDate a.pdf
