# CRLF stays CRLF, also on the line of a copy; a file without a final end of line gets none.
printf 'v 3 1 0\r\nv 1 3 0\r\nvn 0 1 0\r\n\r\nf 1//1 2//1 1//1' >m.obj
deform-mesh m.obj "$DATA/cli/deform-mesh/crease.grid" | od -c
