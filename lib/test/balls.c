/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "balls.h"

#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void random_cage(double (*vertex)[2], size_t n, double roughness, uint64_t *state) {
    for (size_t i = 0; i < n; i++) {
        double angle =
            2 * 3.14159265358979323846 * ((double)i + 0.8 * random_unit(state)) / (double)n;
        double radius = 1 - roughness * random_unit(state);
        vertex[i][0] = radius * cos(angle);
        vertex[i][1] = radius * sin(angle);
    }
}

void planted_domain(struct icc_domain *d, uint32_t columns, uint32_t rows,
                    const unsigned char *bits) {
    *d = (struct icc_domain){.h = 1, .nx = columns + 4, .ny = rows + 4};
    d->inside = calloc(icc_domain_size(d), 1);
    assert_non_null(d->inside);
    for (uint32_t j = 0; j < rows; j++)
        for (uint32_t i = 0; i < columns; i++) {
            d->inside[(j + 2) * d->nx + i + 2] = bits[j * columns + i];
            d->inside_count += bits[j * columns + i];
        }
}

/* Vertices connected with v by edges of the grid. */
static uint32_t connected(const struct icc_domain *d, uint32_t v) {
    uint32_t *queue = calloc(icc_domain_size(d), sizeof *queue), count = 1;
    unsigned char *seen = calloc(icc_domain_size(d), 1);
    const uint32_t next[4] = {1, d->nx, (uint32_t)-1, -d->nx};
    assert_true(queue && seen);
    queue[0] = v;
    seen[v] = 1;
    for (uint32_t at = 0; at < count; at++)
        for (int k = 0; k < 4; k++) {
            uint32_t w = queue[at] + next[k];
            if (!d->inside[w] || seen[w]) continue;
            seen[w] = 1;
            queue[count++] = w;
        }
    free(queue);
    free(seen);
    return count;
}

/* No holes: vertices - edges + squares = 1, the domain being connected. */
bool is_ball(const struct icc_domain *d) {
    int64_t euler = 0;
    uint32_t some = 0;
    for (uint32_t v = 0; v + d->nx + 1 < icc_domain_size(d); v++) {
        bool a = d->inside[v], b = d->inside[v + 1], c = d->inside[v + d->nx];
        bool e = d->inside[v + d->nx + 1];
        euler += a - (a && b) - (a && c) + (a && b && c && e);
        if ((a && e && !b && !c) || (!a && !e && b && c)) return false;
        if (a) some = v;
    }
    return euler == 1 && connected(d, some) == d->inside_count;
}

void random_ball(struct icc_domain *d, uint32_t columns, uint32_t rows, uint32_t count,
                 uint64_t *state) {
    unsigned char *none = calloc((size_t)columns * rows, 1);
    uint32_t tries = 6 * count;
    assert_non_null(none);
    planted_domain(d, columns, rows, none);
    free(none);
    d->inside[d->ny / 2 * d->nx + d->nx / 2] = 1;
    d->inside_count = 1;
    while (d->inside_count < count && tries-- > 0) {
        uint32_t i = 2 + (uint32_t)random_in(state, 0, columns - 1);
        uint32_t j = 2 + (uint32_t)random_in(state, 0, rows - 1), v = j * d->nx + i;
        if (d->inside[v] ||
            !(d->inside[v - 1] || d->inside[v + 1] || d->inside[v - d->nx] || d->inside[v + d->nx]))
            continue;
        d->inside[v] = 1;
        d->inside_count++;
        if (is_ball(d)) continue;
        d->inside[v] = 0;
        d->inside_count--;
    }
}
