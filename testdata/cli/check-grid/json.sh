check-grid --json --per-triangle "$DATA/good/grid/prism.grid"
