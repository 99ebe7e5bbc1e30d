bary
