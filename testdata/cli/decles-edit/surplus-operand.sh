# With -e the only operand is the grid.
decles-edit -e 'unpin all' a.edits a.grid
