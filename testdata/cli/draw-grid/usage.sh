for words in '--layers net,foo' '--layers' '--layers sets' '--edit e.edits' '--edit e.edits:0' '--side up' \
    '--width 10' '--to gif' '-o a.gif' '--no-grid' '--no-grid --lines l.lines a.grid' 'a.grid b.grid'; do
    draw-grid $words
    echo "status $?"
done
