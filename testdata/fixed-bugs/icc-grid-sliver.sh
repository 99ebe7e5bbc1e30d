# SPDX-License-Identifier: GPL-3.0-or-later
# Where the first grid that method grid tried had no vertex inside, and a finer one was good, the
# program printed the coordinates and failed nevertheless, with the first grid's message. Where the
# finer one would have been too large, it gave that up with an error instead of refusing, or taking,
# the finest that is not. And pieces of the cage without values were on sides of its own numbering.
printf '0 0\n1 0.5\n1 0.5003\n0 0.0003\n' >sliver.xy
echo 0.5 0.25015 | icc-map --method grid --digits 6 --coords sliver.xy
printf '0 0\n1 0.9\n1 0.9003\n0 0.0003\n' >aslant.xy
echo 0.5 0.45015 | icc-map --method grid --digits 6 --coords aslant.xy
printf '1 0.55\n9 0.5\n1 0.45\n1 0\n0 0\n0 1.07\n1 1.07\n' >spike.xy
echo 0.5 0.5 | icc-map --method grid --cell 0.1 --digits 6 --coords spike.xy
