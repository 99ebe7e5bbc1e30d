# -n tells what every statement of a script does, and prints no grid.
cat >all.edits <<'END'
edits 1
pin box:0,0,0.2,1 63-65       # the left side stays
weight 2.5 inside:corner.xy
move v@1,0.1 by 0.05 0 reach 1 within 0.2 with 60-62 0
rotate 0:0,0,5 about 1 1 by 30
scale ^1,0.5 v^2,0 about 1 0.5 by 1.25
unpin all
begin
  move v:4 from 0 0 to 0.125 0
  raise both 33 by 0.25 reach 1
  raise top 40 to 2
  suggest 32 to 1.4 0.6
end
END
printf '1.5 0.5\n3 0.5\n3 3\n' >corner.xy
mkgrid --rect 0,0,2,1 --cells 2x1 --depth -1,1 | decles-edit -n all.edits
