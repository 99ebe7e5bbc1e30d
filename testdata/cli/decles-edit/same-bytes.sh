# The statements of a file and those of -e give the same bytes, but for the history.
printf 'edits 1\nmove @1,1 by 0.1 0.05 reach 2\nrotate all about 0 0 by 30\n' >a.edits
decles-edit a.edits "$DATA/good/grid/square.grid" | grep -v '^#' >a.grid
decles-edit -e 'move @1,1 by 0.1 0.05 reach 2' -e 'rotate all about 0 0 by 30' \
    "$DATA/good/grid/square.grid" | grep -v '^#' | cmp - a.grid
