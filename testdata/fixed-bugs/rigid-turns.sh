# SPDX-License-Identifier: GPL-3.0-or-later
# A chain of soft turns of rigid groups was refused: "the positions wanted for the anchors ... break the
# C1 conditions". A condition was held against 64 u of its own terms, but a turn carries the rounding of
# y, which is u |y|, into an x that may be near 0. Errors are now held against the size of the map
# (c1_evaluate). The chain must pass, in one run and in runs of one edit each, with the same bytes.
worm=$DATA/models/virtual_worm_cuticle.obj
cat >turns <<'EOF'
rotate box:3.2,-3,5,3 about 2.6 0.15 by -40 within 1.2
rotate box:2,-3,5,3 about 1.4 -0.4 by 50 within 1.2
rotate box:1.2,-3,5,3 about 0.6 -0.25 by 50 within 1.2
rotate box:0.4,-3,5,3 about -0.2 0.05 by 45 within 1.2
rotate box:-0.4,-3,5,3 about -1 0.25 by 45 within 1.2
rotate box:-1.2,-3,5,3 about -1.8 0.1 by 45 within 1.2
rotate box:-2.3,-3,5,3 about -2.9 -0.05 by -35 within 1.2
rotate all about 100 -300 by 77
rotate all about -1 0 by -50
rotate box:3.2,-3,5,3 about 2.6 0.15 by 10 within 1.2
EOF
mkgrid --model "$worm" --plane zy --cells 40 --margin 0.1 >rest.grid
(echo 'edits 1' && cat turns) | decles-edit - rest.grid | grep -v '^#' >once.grid
while read -r turn; do
    decles-edit -e "$turn" rest.grid >next.grid && mv next.grid rest.grid || exit
done <turns
grep -v '^#' rest.grid | cmp - once.grid && echo same
