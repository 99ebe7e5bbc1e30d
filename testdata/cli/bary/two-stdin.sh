bary -
