# A copy after a last line that has no end of line.
printf 'v 3 1 0\nv 1 3 0\nf 1//1 2//1 1//1\nvn 0 1 0' | deform-mesh - "$DATA/cli/deform-mesh/crease.grid" | od -c
