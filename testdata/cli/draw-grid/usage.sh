for words in '--layers net,foo' '--layers' '--layers sets' '--edit e.edits' '--edit e.edits:0' '--side up' \
    '--width 10' '--to gif' '-o a.gif' '--no-grid' '--frame 0,0,1,1' '--no-grid --lines l.lines a.grid' 'a.grid b.grid' '--dots 3' \
    '--dots 0' '--squares -1' '--line-width x' '--colors red,' '--colors pink'; do
    draw-grid $words
    echo "status $?"
done
for words in '--image x.png --frame 0,0,0,1' '--lines - -' '--edit -:2 -' '--max-pixels 0'; do
    draw-grid $words
    echo "status $?"
done
