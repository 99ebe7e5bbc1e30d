# --limit says what to do instead of the refusal that --no-fold asks for.
decles-edit --limit -e 'unpin all' a.grid
