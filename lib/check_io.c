/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "check_io.h"

#include "c1.h"
#include "report_io.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void report_topology(struct report *r, const struct grid *g, const struct check *c) {
    report_int(r, "degree", g->degree);
    report_int(r, "vertices", g->vertex_count);
    report_int(r, "triangles", g->triangle_count);
    report_int(r, "inner-edges", c->topology.inner_edges);
    report_int(r, "boundary-edges", c->topology.boundary_edges);
    report_int(r, "components", c->topology.components);
    report_int(r, "holes", (int64_t)c->topology.loops - c->topology.components);
    report_int(r, "inner-vertices", c->inner_vertices);
    report_int(r, "singular-vertices", c->singular_vertices);
    report_int(r, "control-points", g->point_count);
    report_text(r, "overlap", c->overlap[0] ? c->overlap : "none");
}

static void report_continuity(struct report *r, const struct grid *g, const struct continuity *c) {
    char key[32];
    report_number(r, "c1-residual", c->absolute);
    report_number(r, "c1-relative-residual", c->relative);
    if (c->worst != GRID_NONE) {
        const uint32_t *e = g->edge[c->worst];
        (void)snprintf(key, sizeof key, "%u %u", e[0], e[1]);
        report_text(r, "c1-worst-edge", key);
    }
    for (int n = 0; n <= g->degree; n++) {
        (void)snprintf(key, sizeof key, "edges-c%d", n);
        if (c->edges[n] > 0 || n < 2) report_int(r, key, c->edges[n]);
    }
    report_int(r, "conditions", (int64_t)c->conditions);
    report_int(r, "rank", (int64_t)c->rank);
    if (g->degree >= 5) report_int(r, "rank-by-formula", (int64_t)c1_rank_formula(g));
    report_int(r, "degrees-of-freedom", (int64_t)g->point_count - (int64_t)c->rank);
}

/* The place as fractions: one word each, numerator and common denominator. */
static void report_place(struct report *r, const char *key, const struct least_place *place) {
    mpz_t sum;
    char *text = NULL;
    mpz_init(sum);
    for (int l = 0; l < 3; l++) mpz_add(sum, sum, place->weight[l]);
    if (gmp_asprintf(&text, "(%Zd %Zd %Zd)/%Zd", place->weight[0], place->weight[1],
                     place->weight[2], sum) > 0)
        report_text(r, key, text);
    free(text);
    mpz_clear(sum);
}

/* Nominal position, rounded. */
static void report_position(struct report *r, const char *key, const struct grid *g, uint32_t t,
                            const struct least_place *place) {
    double weight[3], xy[2] = {0}, sum = 0;
    long exponent[3], most = 0;
    for (int l = 0; l < 3; l++) {
        weight[l] = mpz_get_d_2exp(&exponent[l], place->weight[l]);
        most = exponent[l] > most ? exponent[l] : most;
    }
    for (int l = 0; l < 3; l++) {
        double corner[2];
        weight[l] = ldexp(weight[l], (int)(exponent[l] - most));
        sum += weight[l];
        grid_vertex(g, g->triangle[t][l], corner);
        for (int c = 0; c < 2; c++) xy[c] += weight[l] * corner[c];
    }
    xy[0] /= sum;
    xy[1] /= sum;
    report_numbers(r, key, 2, xy);
}

static void report_certificate(struct report *r, const char *const key[9], const struct grid *g,
                               const struct jacobian_report *j) {
    report_text(r, key[0], jacobian_verdict_names[j->least.verdict]);
    report_number(r, key[1], j->least.low);
    report_number(r, key[2], j->least.high);
    report_int(r, key[3], j->triangle);
    report_place(r, key[4], &j->place);
    report_position(r, key[5], g, j->triangle, &j->place);
    report_number(r, key[6], j->value);
    for (int v = 0; v < 4; v++) {
        char name[64];
        (void)snprintf(name, sizeof name, "%s-%s", key[7], jacobian_verdict_names[v]);
        if (j->count[v] > 0) report_int(r, name, j->count[v]);
    }
}

static void report_triangles(struct report *r, const char *key, const struct grid *g,
                             const struct jacobian_report *j) {
    report_table_begin(r, key);
    for (uint32_t t = 0; t < g->triangle_count; t++) {
        const struct jacobian_bounds *b = &j->bounds_of[t];
        report_row(r, key, t, jacobian_verdict_names[b->verdict], 2, (double[]){b->low, b->high});
    }
    report_table_end(r);
}

static const char *const plane_keys[] = {"local",        "det-lower", "det-upper",
                                         "det-triangle", "det-place", "det-position",
                                         "det-value",    "triangles", "det-of"};
static const char *const thickness_keys[] = {
    "thickness",          "thickness-lower", "thickness-upper",
    "thickness-triangle", "thickness-place", "thickness-position",
    "thickness-value",    "prisms",          "thickness-of"};

void check_write(struct out *out, const struct check *c, const struct spline *s, bool json,
                 bool all) {
    const struct grid *g = &s->grid;
    struct report r;
    struct err ignored;
    report_begin(&r, out, json);
    report_topology(&r, g, c);
    report_continuity(&r, g, &c->continuity);
    report_certificate(&r, plane_keys, g, &c->plane);
    if (s->sigma) {
        report_certificate(&r, thickness_keys, g, &c->thickness);
        report_number(&r, "volume", c->volume);
        report_number(&r, "volume-ratio", c->volume_ratio);
    }
    report_numbers(&r, "sampled-singular-values", 2, c->stretch);
    if (all) report_triangles(&r, plane_keys[8], g, &c->plane);
    if (all && s->sigma) report_triangles(&r, thickness_keys[8], g, &c->thickness);
    report_text(&r, "all-holds", check_holds(c, s, &ignored) ? "yes" : "no");
    report_end(&r);
}
