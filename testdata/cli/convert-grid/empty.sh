convert-grid --to json </dev/null
