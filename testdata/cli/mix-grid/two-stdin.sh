mix-grid 1 - 1 - </dev/null
