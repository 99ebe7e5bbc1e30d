refine-grid --degree 6 --times 2 </dev/null
