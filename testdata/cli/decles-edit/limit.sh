# What folds is carried out as far as it does not, and that is told, each block once; so does a dry run.
mkgrid --rect 0,0,8,6 --cells 4x3 --depth -1,1 >flat.grid
cat >bold.edits <<'END'
edits 1
move v:12 by 0.25 0
begin
  move v:7 by 3.5 0 reach 2
  raise top v:7 by 1
  suggest 40 by 1 0
end
END
decles-edit --no-fold=0.1 --limit -n bold.edits flat.grid
decles-edit --no-fold=0.1 --limit --verbose bold.edits flat.grid 2>&1 >bold.grid |
    sed 's/residual [^ ]*/residual R/; s/displacement.*//'
head -n 4 bold.grid
check-grid --bound 1e-9 bold.grid | grep -E 'local|det-lower|thickness:'
