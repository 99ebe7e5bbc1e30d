/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "net.h"

int net_neighbours(const struct grid *g, uint32_t p, uint32_t t, uint32_t neighbour[6]) {
    int weight[3], n = 0;
    grid_weights(g, p, t, weight);
    for (int from = 0; from < 3; from++)
        for (int to = 0; to < 3; to++) {
            if (from == to || weight[from] == 0) continue;
            weight[from]--, weight[to]++;
            neighbour[n++] = grid_point(g, t, weight[0], weight[1], weight[2]);
            weight[from]++, weight[to]--;
        }
    return n;
}

uint32_t net_line_point(const struct grid *g, uint32_t t, int l, int fixed, int k) {
    int w[3];
    w[l] = fixed;
    w[(l + 1) % 3] = g->degree - fixed - k;
    w[(l + 2) % 3] = k;
    return grid_point(g, t, w[0], w[1], w[2]);
}
