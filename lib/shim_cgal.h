/* SPDX-License-Identifier: GPL-3.0-or-later */
/* shim_cgal - the C face of CGAL's triangulations of points and sides.
 *
 * All signs are exact. Results come in a canonical order, which depends on nothing but the input:
 * vertices are the given points in their order, then Steiner points by (x, y); a triangle is
 * counter-clockwise from its lowest vertex number, and triangles are sorted. No exception, message
 * or state leaves the shim. Cost: O(n log n) for input that is not malicious. */
#ifndef SHIM_CGAL_H
#define SHIM_CGAL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum shim_cgal_status {
    SHIM_CGAL_OK,
    SHIM_CGAL_MEMORY,
    SHIM_CGAL_SAME_POINT, /* points at[0] < at[1] coincide */
    SHIM_CGAL_TOUCH,      /* side at[0] meets another side or a point elsewhere than at its ends */
    SHIM_CGAL_WINDING,    /* the area left of side at[0] is covered `winding` times, not once */
    SHIM_CGAL_FLAT,       /* all points lie on a line */
    SHIM_CGAL_LIMIT,      /* refinement would make more than max_triangles */
    SHIM_CGAL_PRECISION,  /* refinement went below the resolution of doubles */
    SHIM_CGAL_BUG,        /* CGAL gave up: message */
};

struct shim_cgal_report {
    enum shim_cgal_status status;
    size_t at[2];
    int winding;
    char message[256];
};

/* Points and the sides that join them; no side joins a point to itself. */
struct shim_cgal_sides {
    const double (*point)[2];
    size_t point_count; /* below 2^32 - 1, like side_count */
    const uint32_t (*side)[2];
    size_t side_count;
};

/* When is a triangle too bad to stay. Where coordinates are to be rounded to integers, half up,
 * afterwards, the area counts after that rounding. */
struct shim_cgal_criteria {
    bool integers;
    double max_area; /* infinity: any */
    double sine2;    /* square of the sine of the least angle; 0: any */
    size_t max_triangles;
};

struct shim_cgal_mesh { /* released with free() */
    size_t vertex_count, triangle_count;
    double (*vertex)[2];
    uint32_t (*triangle)[3];
};

/* Do the sides bound a domain that lies left of each, is covered once, and is simple: sides share
 * no more than points that end one and begin another? Each point must end one side and begin one.
 */
bool shim_cgal_check(const struct shim_cgal_sides *sides, struct shim_cgal_report *report);

/* Triangulates that domain: constrained Delaunay, refined if criteria is not NULL: points are added
 * on sides and inside until no triangle is bad, except where sides meet at small angles. */
bool shim_cgal_domain(const struct shim_cgal_sides *sides,
                      const struct shim_cgal_criteria *criteria, struct shim_cgal_mesh *mesh,
                      struct shim_cgal_report *report);

/* Constrained Delaunay triangulation of what cannot be reached from infinity, or from a seed,
 * without crossing a side. Any points and sides that meet only at common ends. */
bool shim_cgal_regions(const struct shim_cgal_sides *sides, const double (*seed)[2],
                       size_t seed_count, struct shim_cgal_mesh *mesh,
                       struct shim_cgal_report *report);

/* Delaunay triangulation of the points, all of their convex hull. */
bool shim_cgal_delaunay(const double (*point)[2], size_t n, struct shim_cgal_mesh *mesh,
                        struct shim_cgal_report *report);

#ifdef __cplusplus
}
#endif
#endif
