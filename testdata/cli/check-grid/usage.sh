for words in '--bound 0' '--bound 1' '--undecided -1' '--undecided 1' 'a.grid b.grid'; do
    check-grid $words
    echo "status $?"
done
