/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Grids of polygons: random ones with holes against integer areas, angles and walks along the
 * boundary that share no code with lib/; hostile ones, each refused with its place or meshed right.
 */
#include "domain.h"

#include "testing.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS_MAX = 400, LOOPS_MAX = 8 };

struct loops {
    size_t loop_count, start[LOOPS_MAX + 1];
    double xy[POINTS_MAX][2];
};

static void build(struct polygon *g, const struct loops *l) {
    struct err err;
    size_t n = l->start[l->loop_count];
    *g = (struct polygon){.point_count = n, .loop_count = l->loop_count};
    g->point = calloc(n, sizeof *g->point);
    g->loop_start = calloc(l->loop_count + 1, sizeof *g->loop_start);
    memcpy(g->point, l->xy, n * sizeof *g->point);
    memcpy(g->loop_start, l->start, (l->loop_count + 1) * sizeof *g->loop_start);
    assert_true(polygon_build(g, &err));
}

/* n points around a centre at radii r/2..r and increasing angles: simple. */
static void add_star(struct loops *l, uint64_t *state, int n, double x, double y, double r,
                     bool reversed) {
    size_t first = l->start[l->loop_count];
    for (int i = 0; i < n; i++) {
        double angle = 6.283185307179586 * (i + 0.4 * random_unit(state)) / n;
        double radius = r * (0.5 + 0.5 * random_unit(state));
        size_t at = first + (size_t)(reversed ? n - 1 - i : i);
        l->xy[at][0] = x + radius * cos(angle);
        l->xy[at][1] = y + radius * sin(angle);
    }
    l->start[++l->loop_count] = first + (size_t)n;
}

/* A star of radius r..2r, with stars as holes in some of six disjoint discs of radius r/4. */
static void random_loops(struct loops *l, uint64_t *state) {
    double r = ldexp(1 + random_unit(state), (int)random_in(state, -20, 20));
    double x = r * (double)random_in(state, -3, 3), y = r * (double)random_in(state, -3, 3);
    l->loop_count = 0;
    l->start[0] = 0;
    add_star(l, state, (int)random_in(state, 12, 60), x, y, 2 * r, random_in(state, 0, 1));
    for (int k = 0; k < 6; k++) {
        double angle = 6.283185307179586 * k / 6;
        if (random_in(state, 0, 2)) continue;
        add_star(l, state, (int)random_in(state, 3, 20), x + 0.55 * r * cos(angle),
                 y + 0.55 * r * sin(angle), r / 4, random_in(state, 0, 1));
    }
}

static int64_t area2(const struct grid *g, uint32_t t) {
    const int32_t *a = g->vertex[g->triangle[t][0]], *b = g->vertex[g->triangle[t][1]],
                  *c = g->vertex[g->triangle[t][2]];
    return ((int64_t)b[0] - a[0]) * ((int64_t)c[1] - a[1]) -
           ((int64_t)b[1] - a[1]) * ((int64_t)c[0] - a[0]);
}

/* Twice the area of the polygon through the grid's first vertices: its loops' with alternating sign
 * whatever their sense. */
static int64_t polygon_area2(const struct grid *g, const struct polygon *p) {
    int64_t total = 0;
    for (size_t l = 0; l < p->loop_count; l++) {
        int64_t sum = 0;
        for (size_t i = p->loop_start[l]; i < p->loop_start[l + 1]; i++) {
            const int32_t *a = g->vertex[i], *b = g->vertex[p->next[i]];
            sum += (int64_t)a[0] * b[1] - (int64_t)a[1] * b[0];
        }
        total += (sum < 0 ? -sum : sum) * (l == 0 ? 1 : -1);
    }
    return total;
}

static int64_t grid_area2(const struct grid *g, uint64_t seed) {
    int64_t total = 0;
    for (uint32_t t = 0; t < g->triangle_count; t++) {
        check_seed(seed, area2(g, t) > 0);
        total += area2(g, t);
    }
    return total;
}

/* The grid's first vertices are the polygon's points, nearest on the lattice. */
static void check_points_kept(const struct grid *g, const struct polygon *p, uint64_t seed) {
    check_seed(seed, g->vertex_count >= p->point_count);
    for (size_t i = 0; i < p->point_count; i++) {
        double dx = g->lattice.x0 + g->lattice.step * g->vertex[i][0] - p->point[i][0];
        double dy = g->lattice.y0 + g->lattice.step * g->vertex[i][1] - p->point[i][1];
        check_seed(seed, fabs(dx) <= 0.5 * g->lattice.step && fabs(dy) <= 0.5 * g->lattice.step);
    }
}

static double distance_to_line(const int32_t p[2], const int32_t a[2], const int32_t b[2]) {
    double ux = b[0] - a[0], uy = b[1] - a[1];
    return fabs(ux * (p[1] - a[1]) - uy * (p[0] - a[0])) / hypot(ux, uy);
}

/* Every side is a chain of boundary edges, at most a step away from it, and there is no other
 * boundary. */
static void check_sides_kept(const struct grid *g, const struct polygon *p, uint64_t seed) {
    uint32_t *next = calloc(g->vertex_count, sizeof *next), left = 0;
    for (uint32_t t = 0; t < g->triangle_count; t++)
        for (int l = 0; l < 3; l++) {
            uint32_t e = g->triangle_edge[t][l];
            if (g->edge_triangle[e][1] != GRID_NONE) continue;
            next[g->triangle[t][(l + 1) % 3]] = g->triangle[t][(l + 2) % 3] + 1;
            left++;
        }
    for (uint32_t i = 0; i < p->point_count; i++) {
        uint32_t v = i, end, steps = 0;
        do {
            check_seed(seed, next[v] > 0 && steps++ < g->vertex_count);
            v = next[v] - 1;
            left--;
        } while (v >= p->point_count);
        end = v;
        check_seed(seed, end == p->next[i] || i == p->next[end]);
        for (v = next[i] - 1; v != end; v = next[v] - 1)
            check_seed(seed, distance_to_line(g->vertex[v], g->vertex[i], g->vertex[end]) <= 1);
    }
    check_seed(seed, left == 0);
    free(next);
}

static double angle_at(const int32_t a[2], const int32_t p[2], const int32_t b[2]) {
    double ux = a[0] - p[0], uy = a[1] - p[1], vx = b[0] - p[0], vy = b[1] - p[1];
    return fabs(atan2(ux * vy - uy * vx, ux * vx + uy * vy)) * 57.29577951308232;
}

/* Least angle between neighbouring sides. */
static double least_side_angle(const struct grid *g, const struct polygon *p) {
    double least = 180;
    for (size_t i = 0; i < p->point_count; i++) {
        size_t j = p->next[i];
        least = fmin(least, angle_at(g->vertex[i], g->vertex[j], g->vertex[p->next[j]]));
    }
    return least;
}

/* Snapping moves both ends of an edge by up to 0.71 steps. */
static bool angles_hold(const struct grid *g, double angle) {
    for (uint32_t t = 0; t < g->triangle_count; t++) {
        const int32_t *v[3];
        double shortest = INFINITY, least = 180;
        for (int c = 0; c < 3; c++) v[c] = g->vertex[g->triangle[t][c]];
        for (int c = 0; c < 3; c++) {
            const int32_t *a = v[c], *b = v[(c + 1) % 3];
            shortest = fmin(shortest, hypot(a[0] - b[0], a[1] - b[1]));
            least = fmin(least, angle_at(a, b, v[(c + 2) % 3]));
        }
        if (least < angle - 3 / shortest * 57.29577951308232) return false;
    }
    return true;
}

/* Without refinement: no point more, areas exact to the unit. */
static void check_plain(const struct polygon *p, uint64_t seed) {
    struct domain d = {.lattice = {0, 16}, .max_area = INFINITY, .max_triangles = 100000};
    struct grid g = {.degree = 1, .axes = {0, 1, 2}};
    struct err err;
    check_seed(seed, domain_grid(&g, p, &d, &err));
    check_seed(seed, g.vertex_count == p->point_count);
    check_seed(seed, g.triangle_count == p->point_count + 2 * (p->loop_count - 1) - 2);
    check_seed(seed, grid_area2(&g, seed) == polygon_area2(&g, p));
    check_points_kept(&g, p, seed);
    check_sides_kept(&g, p, seed);
    grid_free(&g);
}

static void check_refined(const struct polygon *p, uint64_t seed, uint64_t *state,
                          int *guaranteed) {
    double box = (p->hi[0] - p->lo[0]) * (p->hi[1] - p->lo[1]), most, area;
    struct domain d = {.lattice = {0, 20}, .max_area = INFINITY, .max_triangles = 1000000};
    struct grid g = {.degree = 1, .axes = {0, 1, 2}};
    struct err err = {0};
    if (random_in(state, 0, 1)) d.max_area = box / (double)random_in(state, 20, 2000);
    if (random_in(state, 0, 3)) d.min_angle = 20.7;
    if (!domain_grid(&g, p, &d, &err)) fprintf(stderr, "seed %d: %s\n", (int)seed, err.message);
    check_seed(seed, err.kind == ERR_NONE);
    check_points_kept(&g, p, seed);
    check_sides_kept(&g, p, seed);
    area = (double)grid_area2(&g, seed);
    most = 8.0 * ldexp(1, 20); /* perimeter in steps, more or less: sides bend by less than one */
    check_seed(seed, fabs(area - (double)polygon_area2(&g, p)) <= most * (double)p->loop_count);
    for (uint32_t t = 0; t < g.triangle_count; t++)
        check_seed(seed, (double)area2(&g, t) / 2 * g.lattice.step * g.lattice.step <= d.max_area);
    if (d.min_angle > 0 && least_side_angle(&g, p) >= 60) {
        check_seed(seed, angles_hold(&g, d.min_angle));
        ++*guaranteed;
    }
    grid_free(&g);
}

static void test_random(void **unused) {
    int guaranteed = 0;
    (void)unused;
    for (int n = 0; n < test_count(1000); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct loops l;
        struct polygon p;
        random_loops(&l, &state);
        build(&p, &l);
        check_plain(&p, seed);
        check_refined(&p, seed, &state, &guaranteed);
        polygon_free(&p);
    }
}

/* Rounded polygons with round holes: angles near 180 degrees, so the angle limit is a promise. */
static void test_guaranteed_angles(void **unused) {
    int guaranteed = 0;
    (void)unused;
    for (int n = 0; n < test_count(100); n++) {
        uint64_t seed = 5000 + (uint64_t)n, state = seed;
        struct loops l = {0};
        struct polygon p;
        int points = (int)random_in(&state, 6, 60);
        for (int k = 0; k < 3; k++) {
            for (int i = 0; i < points; i++) {
                double *xy = l.xy[k * points + i], angle = 6.283185307179586 * i / points;
                double radius = k == 0 ? 10 : 1 + 0.5 * k;
                xy[0] = radius * cos(angle) + (k == 0 ? 0 : k == 1 ? -3 : 3.3);
                xy[1] = radius * sin(angle) + (double)random_in(&state, -1, 1) * 1e-3;
            }
            l.start[++l.loop_count] = (size_t)((k + 1) * points);
        }
        build(&p, &l);
        check_refined(&p, seed, &state, &guaranteed);
        polygon_free(&p);
    }
    assert_true(guaranteed > test_count(100) / 4);
}

static void test_same_bytes(void **unused) {
    uint64_t state = 77;
    (void)unused;
    for (int n = 0; n < test_count(50); n++) {
        struct domain d = {.lattice = {0, 16}, .max_area = INFINITY, .min_angle = 20, 1000000};
        struct grid a = {.degree = 1, .axes = {0, 1, 2}}, b = a;
        struct loops l;
        struct polygon p;
        struct err err;
        void *holes[100];
        random_loops(&l, &state);
        build(&p, &l);
        assert_true(domain_grid(&a, &p, &d, &err));
        for (size_t i = 0; i < 100; i++) holes[i] = malloc((i * 7919 + (size_t)n * 104729) % 40000);
        for (size_t i = 0; i < 100; i += 2) free(holes[i]);
        assert_true(domain_grid(&b, &p, &d, &err));
        for (size_t i = 1; i < 100; i += 2) free(holes[i]);
        assert_int_equal(a.vertex_count, b.vertex_count);
        assert_int_equal(a.triangle_count, b.triangle_count);
        assert_memory_equal(a.vertex, b.vertex, a.vertex_count * sizeof *a.vertex);
        assert_memory_equal(a.triangle, b.triangle, a.triangle_count * sizeof *a.triangle);
        grid_free(&a);
        grid_free(&b);
        polygon_free(&p);
    }
}

/* "x y x y ... / x y ..": loops. */
static void parse(struct loops *l, const char *text) {
    char *next;
    size_t n = 0;
    *l = (struct loops){0};
    for (const char *at = text; *at;) {
        if (*at == '/') {
            l->start[++l->loop_count] = n;
            at++;
            continue;
        }
        l->xy[n][0] = strtod(at, &next);
        l->xy[n++][1] = strtod(next, &next);
        for (at = next; *at == ' ';) at++;
    }
    l->start[++l->loop_count] = n;
}

struct hostile {
    const char *loops, *message; /* NULL: meshed */
    int area2;                   /* of the polygon, in world units */
};

static const struct hostile hostile[] = {
    {"0 0 4 4 4 0 0 4", "the side from (4, 0) to (0, 4) crosses the side from (0, 0) to", 0},
    {"0 0 4 0 4 0 4 4", "a side has no length, at (4, 0)", 0},
    {"0 0 4 0 4 4 0 4 0 0", "a side has no length, at (0, 0)", 0},
    {"0 0 2 2 4 0 4 4 2 2 0 4", "two points are at (2, 2)", 0},
    {"0 0 2 0 4 0 4 4 2 0 0 4", "two points are at (2, 0)", 0},
    {"0 0 4 0 4 4 2 0 0 4", "point (2, 0) lies on the side from (0, 0) to (4, 0)", 0},
    {"0 0 4 0 8 0 6 0 6 4 0 4", "point (6, 0) lies on the side from (4, 0) to (8, 0)", 0},
    {"0 0 4 0 4 4 4 9 4 5 0 4", "lies on the side from (4, 4) to (4, 9)", 0},
    {"0 0 4 0 8 0", "all points lie on a line", 0},
    {"0 0 8 0 8 8 0 8/9 9 9 10 10 9", "hole 1, at (9, 9), lies outside the outline", 0},
    {"0 0 8 0 8 8 0 8/8 2 9 2 9 3", "lies on the side from (8, 0) to (8, 8)", 0},
    {"0 0 8 0 8 8 0 8/0 0 1 0.5 0.5 1", "two points are at (0, 0)", 0},
    {"0 0 8 0 8 8 0 8/7 2 9 2 7 3", "crosses the side from", 0},
    {"0 0 8 0 8 8 0 8/1 1 7 1 7 7 1 7/3 3 4 3 3 4", "hole 2, at (3, 3), lies in hole 1", 0},
    {"0 0 8 0 8 8 0 8/3 3 4 3 3 4/1 1 7 1 7 7 1 7", "hole 1, at (3, 3), lies in hole 2", 0},
    {"0 0 8 0 8 8 0 8/-1 -1 9 -1 9 9 -1 9", "hole 1 encloses the outline", 0},
    {"0 0 8 0 8 8 0 8/1 1 2 1 1 2/2 1 3 1 3 2", "two points are at (2, 1)", 0},
    {"0 0 8 0 8 8 0 8/0 0 8 0 8 8 0 8", "two points are at (0, 0)", 0},
    {"0 0 1 0", NULL, -1},
    /* sound, though not nice: collinear points, both senses, a neck, near holes, a needle */
    {"0 0 2 0 4 0 4 4 0 4 0 2", NULL, 32},
    {"0 4 4 4 4 0 0 0", NULL, 32},
    {"0 0 8 0 8 8 0 8/1 1 7 1 7 7 1 7", NULL, 56},
    {"0 0 8 0 8 8 0 8/1 7 7 7 7 1 1 1", NULL, 56},
    {"0 0 4 0 4 1.999 5 1.999 5 0 9 0 9 4 5 4 5 2 4 2 4 4 0 4", NULL, 64},
    {"0 0 8 0 8 8 0 8/0.001 0.001 4 0.001 4 3/4.001 0.001 7.9 0.001 7.9 7.9", NULL, 85},
    {"0 0 1000 0.5 1000 1.5", NULL, 1000},
    {"0 0 8 0 8 8 0 8/1 1 1.25 1 1 1.25", NULL, 128},
};

static void test_hostile(void **unused) {
    (void)unused;
    for (size_t i = 0; i < sizeof hostile / sizeof *hostile; i++) {
        const struct hostile *h = &hostile[i];
        struct domain d = {.lattice = {0, 20}, INFINITY, .min_angle = 20.7, 100000};
        struct grid g = {.degree = 1, .axes = {0, 1, 2}};
        struct err err = {0};
        struct loops l;
        struct polygon p;
        bool ok;
        parse(&l, h->loops);
        build(&p, &l);
        ok = domain_grid(&g, &p, &d, &err);
        if (h->message || h->area2 < 0) {
            if (ok || (h->message && !strstr(err.message, h->message)))
                fail_msg("%s: got '%s'", h->loops, err.message);
            assert_int_equal(err.kind, ERR_REFUSAL);
        } else {
            if (!ok) fail_msg("%s: got '%s'", h->loops, err.message);
            check_points_kept(&g, &p, i);
            check_sides_kept(&g, &p, i);
            assert_true(fabs((double)grid_area2(&g, i) * g.lattice.step * g.lattice.step -
                             h->area2) < 0.25);
        }
        grid_free(&g);
        polygon_free(&p);
    }
}

static void refused(const char *loops, const struct domain *d, const char *message) {
    struct grid g = {.degree = 1, .axes = {0, 1, 2}};
    struct err err = {0};
    struct loops l;
    struct polygon p;
    parse(&l, loops);
    build(&p, &l);
    if (domain_grid(&g, &p, d, &err) || !strstr(err.message, message))
        fail_msg("%s: got '%s'", loops, err.message);
    assert_int_equal(err.kind, ERR_REFUSAL);
    grid_free(&g);
    polygon_free(&p);
}

static void test_coarse_lattice(void **unused) {
    struct domain d = {.lattice = {0, 4}, INFINITY, .min_angle = 0, 100000};
    (void)unused;
    refused("0 0 8 0 8 8 0 8/1 1 1.1 1 1 2", &d, "lattice too coarse: points 4 and 5");
    refused("0 0 8 0 8 8 0 8/1 1 1.1 1 1 2", &d, "try --lattice-bits 8");
    refused("0 0 15.9 0 15.9 8 8 0.3 0 8", &d,
            "lattice too coarse: then the point (8, 0.3) lies on the side from (0, 0)");
    d.lattice = (struct lattice_choice){1, 8};
    refused("0 0 15.9 0 15.9 8 8 0.3 0 8", &d, "try --lattice 0.0625");
    d.lattice = (struct lattice_choice){1, 5};
    refused("0 0 15.9 0 15.9 8 8 0.3 0 8", &d, "try --lattice 0.0625 --lattice-bits 9");
    d = (struct domain){.lattice = {1, 16}, .max_area = 3, .max_triangles = 100000};
    refused("0 0 64 0 64 64 0 64", &d, "lattice too coarse: a triangle of area 3");
    d = (struct domain){.lattice = {1, 16}, .max_area = INFINITY, 20, 100000};
    refused("0 0 64 0 64 64 0 64/31 31 32 31 32 32", &d, "lattice too coarse: the triangle with");
}

static void test_limits(void **unused) {
    struct domain d = {.lattice = {0, 24}, .max_area = 0.01, .min_angle = 20, 1000};
    (void)unused;
    refused("0 0 8 0 8 8 0 8", &d, "more than 1000 triangles are needed");
    d = (struct domain){.lattice = {0, 24}, .max_area = INFINITY, .min_angle = 45, 5000};
    refused("0 0 8 0 8 7 0 8", &d, "more than 5000 triangles are needed");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),         cmocka_unit_test(test_guaranteed_angles),
        cmocka_unit_test(test_same_bytes),     cmocka_unit_test(test_hostile),
        cmocka_unit_test(test_coarse_lattice), cmocka_unit_test(test_limits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
