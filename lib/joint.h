/* SPDX-License-Identifier: GPL-3.0-or-later */
/* joint - a triangulation that lies in two planes at once, a piecewise affine map from one to the
 * other, which is brought to places that can be written and stays sound meanwhile.
 *
 * Sound is: every triangle is strictly counter-clockwise in both planes, decided exactly. A vertex
 * lies either where it is *meant* (a rational, say the crossing of two edges, of which a rounded
 * place is known), or where it is *settled*, a double. To begin with all are where they are meant,
 * and the triangulation is sound; then each is settled at the double wished for, in both planes
 * together, if that leaves its triangles sound, and otherwise taken away: the polygon of its
 * neighbours is triangulated anew. So it is always a map without folds, and what has to give way is
 * what lies closer together than the doubles can tell. Where neither is possible, a vertex moves on
 * to another place near by, or others around it are taken away.
 *
 * Vertices may be fixed: those are never taken away. A vertex on the boundary may be taken away
 * like others; its two edges there become one. */
#ifndef JOINT_H
#define JOINT_H

#include "plane_map.h"

#include <gmp.h>

#define JOINT_NONE UINT32_MAX

/* Where vertices are meant to lie. */
struct joint_meaning {
    void (*exact)(const void *context, uint32_t vertex, int plane, mpq_t p[2]);
    const void *context;
    double error[2]; /* the places given are no further away, in either coordinate */
};

struct joint_places; /* exact places in use */

struct joint {
    struct plane_map map; /* places that are meant, rounded */
    uint32_t *twin;       /* halfedge.h */
    uint32_t *corner;     /* of each vertex: 3 t + c where it is corner c of t; NONE: taken away */
    bool *fixed, *settled;
    double (*wish[2])[2];                /* places when settled; NULL: all are as they are meant */
    int digits[2];                       /* of these places, as in num_print */
    const struct joint_meaning *meaning; /* NULL: the places are exact */
    struct joint_places *exact[2];
};

/* Takes over the map, which is sound with each vertex where it is meant, and is zeroed. Triangles
 * that are taken away have JOINT_NONE as vertices. Freed by joint_free in any case. */
bool joint_init(struct joint *j, struct plane_map *map, const struct joint_meaning *meaning,
                struct err *err) WARN_UNUSED;
void joint_free(struct joint *j); /* harmless on a zeroed struct */

/* Settles all vertices, at places with so many significant digits in either plane (0: any double),
 * which become the map's. What lies closer together than `slack` times the rounding is thinned out
 * first, where it matters; with more than JOINT_SLACK everywhere. Refuses (precision) if the
 * vertices cannot be settled; another joint may, with more slack. About 1 us a vertex, plus some 20
 * us for each that has to give way. */
#define JOINT_SLACK 3
bool joint_settle(struct joint *j, const int digits[2], double slack, struct err *err) WARN_UNUSED;

/* Takes away inner vertices and others of triangles that are not sound, of a joint whose vertices
 * are exact, as long as that leaves fewer such triangles. Returns how many are left. */
bool joint_mend(struct joint *j, size_t *left, struct err *err) WARN_UNUSED;

/* Takes vertices away as long as no triangle becomes larger than max_area in the source, nor less
 * round than the worst one around the vertex and than 0.02 (plane_map_roundness, in the worse
 * plane). */
bool joint_thin(struct joint *j, double max_area, struct err *err) WARN_UNUSED;

/* Hands over the map without what was taken away. */
bool joint_finish(struct joint *j, struct plane_map *map, struct err *err) WARN_UNUSED;

/* Where a vertex is now, rounded. */
static inline const double *joint_place(const struct joint *j, int plane, uint32_t v) {
    /* cppcheck-suppress CastIntegerToAddressAtReturn */
    return j->settled[v] ? j->wish[plane][v] : j->map.at[plane][v];
}

/* On which side of a->b lies c, as the vertices are now. */
int joint_orient(struct joint *j, int plane, uint32_t a, uint32_t b, uint32_t c);

/* Is triangle t sound? */
bool joint_is_sound(struct joint *j, uint32_t t);

/* The triangles around a vertex, counter-clockwise, from the one at the boundary if it lies there.
 */
struct joint_star {
    bool boundary;
    size_t count;
    uint32_t *corner; /* of the vertex in each triangle */
    size_t cap;
};

bool joint_star(const struct joint *j, uint32_t v, struct joint_star *star,
                struct err *err) WARN_UNUSED;

/* Takes a vertex away, if its star can be triangulated soundly without it; *done says so. Where it
 * lies close to a neighbour, that one takes its part if possible; else the roundest triangulation
 * is taken. Vertices with more than JOINT_STAR_MAX triangles stay. */
enum { JOINT_STAR_MAX = 100 };
bool joint_remove(struct joint *j, uint32_t v, struct joint_star *star, bool *done,
                  struct err *err) WARN_UNUSED;

/* Settles an inner vertex, whose star is given, at the place nearest to the meant one where it is
 * sound, among many that are tried; within `reach` times the distance to which it would be rounded.
 */
bool joint_move(struct joint *j, uint32_t v, const struct joint_star *star, double reach);

/* How far, at most, a coordinate of v lies from its rounded value, about. */
double joint_rounding(const struct joint *j, int plane, uint32_t v);

/* Drops exact places; they are found again when needed. */
void joint_forget(struct joint *j);

#endif
