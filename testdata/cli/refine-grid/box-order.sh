refine-grid --box 1,0,0,1 </dev/null
