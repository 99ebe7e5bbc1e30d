/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "check_io.h"

#include "c1.h"
#include "report_io.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void report_overlap(struct report *r, const struct overlap *o) {
    static const char *const kinds[] = {
        [OVERLAP_NONE] = "none", [OVERLAP_TOUCH] = "touch", [OVERLAP_AREA] = "overlap"};
    char text[64];
    report_text(r, "overlap", kinds[o->kind]);
    if (o->kind == OVERLAP_NONE) return;
    (void)snprintf(text, sizeof text, "%u %u", o->triangle[0], o->triangle[1]);
    report_text(r, "overlap-triangles", text);
    report_text(r, "overlap-place", o->text);
}

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
    report_overlap(r, &c->injective.overlap);
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

/* An edge, and the interval of its parameter: from the one vertex at 0 to the other at 1. */
static void report_boundary_place(struct report *r, int i, const struct boundary_meeting *m) {
    const struct boundary_place *place = &m->place[i];
    char key[32], *text = NULL;
    (void)snprintf(key, sizeof key, "boundary-place-%d", i + 1);
    if (gmp_asprintf(&text, "%u %u %Qd %Qd", place->from, place->to, m->meet.lo[i], m->meet.hi[i]) >
        0)
        report_text(r, key, text);
    free(text);
    (void)snprintf(key, sizeof key, "boundary-triangle-%d", i + 1);
    report_int(r, key, place->triangle);
    (void)snprintf(key, sizeof key, "boundary-position-%d", i + 1);
    report_numbers(r, key, 2, place->position);
}

static void report_boundary(struct report *r, const struct boundary_meeting *m) {
    static const char *const verdicts[] = {[MEET_NOT] = "simple",
                                           [MEET_UNDECIDED] = "undecided",
                                           [MEET_CROSS] = "crosses",
                                           [MEET_POINT] = "meets"};
    report_text(r, "boundary", verdicts[m->meet.verdict]);
    if (m->meet.verdict == MEET_NOT) return;
    for (int i = 0; i < 2; i++) report_boundary_place(r, i, m);
    report_numbers(r, "boundary-image", 2, m->image);
    if (m->meet.verdict == MEET_UNDECIDED) report_number(r, "boundary-distance", m->meet.distance);
}

static void report_injective(struct report *r, const struct injective *j, bool depth) {
    static const char *const fans[] = {[FAN_SOUND] = "once",
                                       [FAN_COVERS] = "more",
                                       [FAN_CLOSES] = "full-turn",
                                       [FAN_UNKNOWN] = "unknown"};
    static const char *const nestings[] = {
        [NESTING_NONE] = "none", [NESTING_UNDECIDED] = "undecided", [NESTING_INSIDE] = "inside"};
    report_text(r, "windings", fans[j->fans]);
    if (j->fans != FAN_SOUND) report_int(r, "windings-vertex", j->fan_vertex);
    report_boundary(r, &j->boundary);
    report_text(r, "containment",
                j->boundary.meet.verdict == MEET_NOT ? nestings[j->nesting.verdict]
                                                     : "not-examined");
    if (j->nesting.verdict == NESTING_INSIDE) {
        report_int(r, "containment-vertex", j->nesting.vertex);
        report_int(r, "containment-triangle", j->nesting.triangle);
    }
    report_text(r, "one-to-one", injective_verdict_names[j->phi]);
    if (depth) report_text(r, "psi-one-to-one", injective_verdict_names[j->psi]);
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
    if (s->sigma) report_certificate(&r, thickness_keys, g, &c->thickness);
    report_injective(&r, &c->injective, s->sigma != NULL);
    if (s->sigma) {
        report_number(&r, "volume", c->volume);
        report_number(&r, "volume-ratio", c->volume_ratio);
    }
    report_numbers(&r, "sampled-singular-values", 2, c->stretch);
    if (all) report_triangles(&r, plane_keys[8], g, &c->plane);
    if (all && s->sigma) report_triangles(&r, thickness_keys[8], g, &c->thickness);
    report_text(&r, "all-holds", check_holds(c, s, &ignored) ? "yes" : "no");
    report_end(&r);
}
