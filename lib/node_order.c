/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The degree 5 nested, places in base 36 (left), and its interior by rows (right):
 *
 *                2                              .
 *               8 7... b                       . .
 *              c . a                          . k .
 *             d . . 9                        . i j .
 *            e . . . 8                      . f g h .
 *           0 3 4 5 6 1                    . . . . . . */
#include "node_order.h"

/* The boundary of the triangle whose nodes have weights >= ring and the corner weight
 * ring + degree; returns the next place. */
static int boundary(int degree, int ring, int q, int weight[][3]) {
    int corners = degree == 0 ? 1 : 3;
    for (int l = 0; l < corners; l++, q++) {
        for (int m = 0; m < 3; m++) weight[q][m] = ring;
        weight[q][l] += degree;
    }
    for (int l = 0; l < 3; l++)
        for (int r = 1; r < degree; r++, q++) {
            for (int m = 0; m < 3; m++) weight[q][m] = ring;
            weight[q][l] += degree - r;
            weight[q][(l + 1) % 3] += r;
        }
    return q;
}

void node_order(int degree, enum node_interior interior, int weight[][3]) {
    int q = boundary(degree, 0, 0, weight);
    if (interior == NODE_NESTED) {
        for (int ring = 1; degree - 3 * ring >= 0; ring++)
            q = boundary(degree - 3 * ring, ring, q, weight);
        return;
    }
    for (int k = 1; k < degree; k++)
        for (int j = 1; j + k < degree; j++, q++) {
            weight[q][0] = degree - j - k;
            weight[q][1] = j;
            weight[q][2] = k;
        }
}
