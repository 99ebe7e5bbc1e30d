# title: From suggested positions to the solution
# paper: Not known to us. By section 5.1 each derived point gets a suggested position p', the farther from
#   the anchor the nearer to where it was; the solution p'' is the nearest to all p', in least squares, that
#   keeps the conditions (13)-(23).
# seen: Light arrows lead from p to p', dark ones from p' to p''. The dark ones are hardly to be seen: the
#   suggestions are nearly smooth already, and the solution mends what is not. No point moves farther than
#   {gain} times the anchor.
mkgrid --rect 0,0,6,4 --cells 3x2 -o flat.grid
printf 'edits 1\nmove v^4,2 by 0.8 0.5 reach 6\n' >one.edits
decles-edit --verbose one.edits flat.grid 2>&1 >/dev/null | awk -f "$HERE/lib/counts.awk"
draw-grid --edit one.edits:2 --side both -o decles14-16-suggest.png flat.grid
