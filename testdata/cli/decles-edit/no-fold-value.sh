# The margin is a number, 0 or more.
decles-edit --no-fold=-1 -e 'unpin all' a.grid
