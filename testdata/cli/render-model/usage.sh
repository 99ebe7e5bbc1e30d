printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >m.obj
for words in '--view up' '--view 1' '--view 10,91' '--shade x' '--plane xx' '--size 0x0' '--antialias 17' \
    '--background puce' '--grid - -' '--compare - -' '-o a.gif' 'm.obj m.obj' '--layers net' \
    '--grid a.grid --layers quad' '--grid a.grid --controls up' '--controls top' '--no-model' '--grid a.grid --no-model m.obj'; do
    render-model $words
    echo "status $?"
done
for words in '--frames list m.obj' '--frames list -o a.png' '--frames - --grid -' '--max-pixels 0' \
    '--size 10x10 --max-pixels 99 m.obj'; do
    render-model $words
    echo "status $?"
done
