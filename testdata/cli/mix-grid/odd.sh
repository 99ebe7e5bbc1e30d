mix-grid 1 a.grid 2
