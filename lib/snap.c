/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "snap.h"

#include "mem.h"
#include "radix.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

enum { FINER_BITS = 4, BITS_MAX = 24 };

static bool fit(struct snap *s, const double (*point)[2], size_t n, struct err *err) {
    double low[2] = {point[0][0], point[0][1]}, high[2] = {low[0], low[1]}, far = 0;
    for (size_t i = 0; i < n; i++)
        for (int c = 0; c < 2; c++) {
            low[c] = fmin(low[c], point[i][c]);
            high[c] = fmax(high[c], point[i][c]);
            far = fmax(far, fabs(point[i][c]));
        }
    s->span = fmax(high[0] - low[0], high[1] - low[1]);
    if (!isfinite(s->span)) return err_set(err, ERR_REFUSAL, "the points' box is too large");
    if (!lattice_step(&s->choice, s->span, far, &s->lattice.step, err)) return false;
    s->lattice.x0 = lattice_nearest(low[0], s->lattice.step);
    s->lattice.y0 = lattice_nearest(low[1], s->lattice.step);
    return true;
}

bool snap_init(struct snap *s, const struct lattice_choice *choice, const double (*point)[2],
               size_t n, struct err *err) {
    *s = (struct snap){.choice = *choice, .count = n};
    if (!fit(s, point, n, err) || !mem_new(s->at, n, err)) return false;
    for (size_t i = 0; i < n; i++) {
        s->at[i][0] = (int32_t)floor((point[i][0] - s->lattice.x0) / s->lattice.step + 0.5);
        s->at[i][1] = (int32_t)floor((point[i][1] - s->lattice.y0) / s->lattice.step + 0.5);
    }
    return true;
}

void snap_free(struct snap *s) {
    free(s->at);
    s->at = NULL;
}

/* Finds the lowest point b that has a point a < b at its place. */
static bool find_same(const struct snap *s, struct radix_item *item, struct radix_item *spare,
                      uint32_t *a, uint32_t *b) {
    bool found = false;
    for (uint32_t i = 0; i < s->count; i++) {
        uint64_t x = (uint32_t)s->at[i][0], y = (uint32_t)s->at[i][1];
        item[i] = (struct radix_item){x << 32 | y, i};
    }
    radix_sort(item, spare, s->count);
    for (size_t i = 1; i < s->count; i++) {
        if (item[i - 1].key != item[i].key || (found && item[i].value > *b)) continue;
        *a = item[i - 1].value;
        *b = item[i].value;
        found = true;
    }
    return found;
}

bool snap_check_distinct(const struct snap *s, const double (*point)[2], struct err *err) {
    struct radix_item *item, *spare = NULL;
    uint32_t a = 0, b = 0;
    bool ok = mem_new(item, s->count, err) && mem_new(spare, s->count, err);
    if (ok && find_same(s, item, spare, &a, &b)) {
        const double *p = point[a], *q = point[b];
        if (p[0] == q[0] && p[1] == q[1])
            ok = err_set(err, ERR_REFUSAL, "points %u and %u are both at (%.9g, %.9g)", a, b, p[0],
                         p[1]);
        else
            ok = snap_refuse(s, err, "points %u and %u, at (%.9g, %.9g) and (%.9g, %.9g), coincide",
                             a, b, p[0], p[1], q[0], q[1]);
    }
    free(item);
    free(spare);
    return ok;
}

void snap_world(const struct snap *s, const int32_t at[2], double world[2]) {
    world[0] = lattice_coordinate(s->lattice.x0, s->lattice.step, at[0], 1);
    world[1] = lattice_coordinate(s->lattice.y0, s->lattice.step, at[1], 1);
}

/* A step 2^FINER_BITS times finer, or as many bits more. */
static void advise(const struct snap *s, char *text, size_t room) {
    double step = s->lattice.step, finer = ldexp(step, -FINER_BITS);
    int bits = s->choice.bits;
    if (s->choice.step > 0 && s->span / finer < ldexp(1, bits))
        snprintf(text, room, "try --lattice %.17g", finer);
    else if (bits >= BITS_MAX)
        snprintf(text, room, "no lattice can be finer");
    else {
        bits = bits + FINER_BITS < BITS_MAX ? bits + FINER_BITS : BITS_MAX;
        if (s->choice.step > 0)
            while (s->span / finer >= ldexp(1, bits)) finer *= 2;
        if (s->choice.step > 0)
            snprintf(text, room, "try --lattice %.17g --lattice-bits %d", finer, bits);
        else
            snprintf(text, room, "try --lattice-bits %d", bits);
    }
}

bool snap_refuse(const struct snap *s, struct err *err, const char *format, ...) {
    char what[sizeof err->message], advice[128];
    va_list args;
    va_start(args, format);
    vsnprintf(what, sizeof what, format, args);
    va_end(args);
    advise(s, advice, sizeof advice);
    return err_set(err, ERR_REFUSAL, "lattice too coarse: %.500s; %s", what, advice);
}
