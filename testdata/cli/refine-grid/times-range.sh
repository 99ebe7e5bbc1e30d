refine-grid --times 25 </dev/null
