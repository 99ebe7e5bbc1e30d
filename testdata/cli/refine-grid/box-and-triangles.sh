refine-grid --box 0,0,1,1 --triangles 0 </dev/null
