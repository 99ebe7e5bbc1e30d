# A NUL byte in a label or a file name cut it short: found by fuzz-lines and fuzz-frames.
printf '0 0 \0n\n' >nul.lines
draw-grid --no-grid --to svg --lines nul.lines || echo "status $?"
