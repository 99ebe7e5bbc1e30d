/* SPDX-License-Identifier: GPL-3.0-or-later */
/* halfedge - neighbours in a triangulation.
 *
 * Half edge 3 t + l runs along edge l of triangle t, which lies opposite its corner l, counter-
 * clockwise: from corner l + 1 to corner l + 2 (modulo 3). Its twin runs the other way along the
 * same edge, in the neighbour; on the boundary there is none. */
#ifndef HALFEDGE_H
#define HALFEDGE_H

#include "err.h"

#include <stdint.h>

#define HALFEDGE_NONE UINT32_MAX

static inline uint32_t halfedge_next(uint32_t h) {
    return h % 3 == 2 ? h - 2 : h + 1;
}

static inline uint32_t halfedge_prev(uint32_t h) {
    return h % 3 == 0 ? h + 2 : h - 1;
}

static inline uint32_t halfedge_from(const uint32_t (*triangle)[3], uint32_t h) {
    return triangle[h / 3][(h + 1) % 3];
}

static inline uint32_t halfedge_to(const uint32_t (*triangle)[3], uint32_t h) {
    return triangle[h / 3][(h + 2) % 3];
}

/* The vertex opposite. */
static inline uint32_t halfedge_apex(const uint32_t (*triangle)[3], uint32_t h) {
    return triangle[h / 3][h % 3];
}

/* Sets *twin to an array of 3 * triangle_count half edges, the caller's to free. No two half edges
 * run the same way; triangle_count < 2^32 / 3. O(n). */
bool halfedge_twins(uint32_t **twin, const uint32_t (*triangle)[3], size_t triangle_count,
                    struct err *err) WARN_UNUSED;

#endif
