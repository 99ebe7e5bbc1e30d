/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "foldfree.h"

#include "jacobian_path.h"
#include "mem.h"
#include "num.h"
#include "rational.h"

#include <stdio.h>
#include <string.h>

struct foldfree {
    const struct spline *now;
    struct spline before; /* the same grid; control points of our own, set where touched */
    double margin;
    struct least_room *room;
    bool *touched; /* of each triangle */
    uint32_t *triangle;
    size_t count, cap;
};

struct foldfree *foldfree_new(const struct spline *s, double margin, struct err *err) {
    size_t n = s->grid.point_count;
    struct foldfree *f;
    if (!mem_new(f, 1, err)) return NULL;
    f->now = s;
    f->before.grid = s->grid;
    f->margin = margin;
    if (!mem_new(f->before.phi, n, err) || (s->sigma && !mem_new(f->before.sigma, n, err)) ||
        !mem_new(f->touched, s->grid.triangle_count, err) || !(f->room = least_room_new(err))) {
        foldfree_free(f);
        return NULL;
    }
    return f;
}

void foldfree_free(struct foldfree *f) {
    if (!f) return;
    free(f->before.phi);
    free(f->before.sigma);
    free(f->touched);
    free(f->triangle);
    least_room_free(f->room);
    free(f);
}

/* ---- what an edit touches ---- */

void foldfree_begin(struct foldfree *f) {
    while (f->count > 0) f->touched[f->triangle[--f->count]] = false;
}

static void copy_patch(struct foldfree *f, uint32_t t) {
    const struct spline *s = f->now;
    uint32_t q[GRID_PATCH_MAX];
    grid_patch(&s->grid, t, q);
    for (int i = 0; i < grid_patch_size(s->grid.degree); i++) {
        memcpy(f->before.phi[q[i]], s->phi[q[i]], sizeof *s->phi);
        if (s->sigma) memcpy(f->before.sigma[q[i]], s->sigma[q[i]], sizeof *s->sigma);
    }
}

bool foldfree_touch(struct foldfree *f, const uint32_t *points, size_t n, struct err *err) {
    for (size_t i = 0; i < n; i++) {
        uint32_t single, m;
        const uint32_t *t = grid_triangles_of(&f->now->grid, points[i], &single, &m);
        if (!mem_grow(f->triangle, &f->cap, f->count + m, err)) return false;
        for (uint32_t j = 0; j < m; j++) {
            if (f->touched[t[j]]) continue;
            f->touched[t[j]] = true;
            f->triangle[f->count++] = t[j];
            copy_patch(f, t[j]);
        }
    }
    return true;
}

void foldfree_was(struct foldfree *f, enum foldfree_component c, uint32_t point,
                  const double *from) {
    if (c == FOLDFREE_PHI)
        memcpy(f->before.phi[point], from, sizeof *f->before.phi);
    else
        f->before.sigma[point][c - FOLDFREE_BOTTOM] = *from;
}

/* ---- what is said of a triangle that is not above the margin ---- */

/* The place as fractions, "(3 0 1)/4 = ", unless they are long, and as decimals. */
static void describe_place(const struct least_place *place, size_t room, char *text) {
    char fractions[200] = "";
    double decimal[3];
    mpz_t sum;
    mpq_t b;
    mpz_init(sum);
    mpq_init(b);
    for (int l = 0; l < 3; l++) mpz_add(sum, sum, place->weight[l]);
    if (mpz_sizeinbase(sum, 10) <= 40)
        (void)gmp_snprintf(fractions, sizeof fractions, "(%Zd %Zd %Zd)/%Zd = ", place->weight[0],
                           place->weight[1], place->weight[2], sum);
    for (int l = 0; l < 3; l++) {
        mpz_set(mpq_numref(b), place->weight[l]);
        mpz_set(mpq_denref(b), sum);
        mpq_canonicalize(b);
        decimal[l] = rational_round(b);
    }
    (void)snprintf(text, room, "%s%.6g %.6g %.6g", fractions, decimal[0], decimal[1], decimal[2]);
    mpz_clear(sum);
    mpq_clear(b);
}

struct number {
    char text[NUM_TEXT_MAX + 1];
};

static struct number number(double x) {
    struct number n;
    n.text[num_print(n.text, x, 0)] = '\0';
    return n;
}

/* What the path's triangle is at share s. */
static bool describe(const struct jacobian_path *p, double s, enum jacobian_verdict verdict,
                     const struct least_place *place, char text[FOLDFREE_TEXT_MAX],
                     struct err *err) {
    const char *what = p->kind == JACOBIAN_PLANE ? "det grad phi" : "(sigma1-sigma0)/(b-a)";
    struct number margin = number(p->margin);
    char where[280];
    double value;
    if (verdict == JACOBIAN_UNDECIDED) {
        (void)snprintf(text, FOLDFREE_TEXT_MAX, "triangle %u: %s > %s could not be decided",
                       p->triangle, what, margin.text);
        return true;
    }
    if (!jacobian_path_value(p, s, place, &value, err)) return false;
    describe_place(place, sizeof where, where);
    (void)snprintf(text, FOLDFREE_TEXT_MAX, "triangle %u: expected %s > %s, got %s at %s",
                   p->triangle, what, margin.text, number(value).text, where);
    return true;
}

/* ---- certificates ---- */

static int kinds(const struct foldfree *f) {
    return f->now->sigma ? 2 : 1;
}

static void path_of(const struct foldfree *f, size_t i, struct jacobian_path *p) {
    size_t n = (size_t)kinds(f);
    jacobian_path_init(p, &f->before, f->now, i % n ? JACOBIAN_THICKNESS : JACOBIAN_PLANE,
                       f->triangle[i / n], f->margin);
}

/* The path ends below the margin, or undecided: was it so when it began? */
static bool refuse(const struct foldfree *f, struct jacobian_path *p, enum jacobian_verdict verdict,
                   struct least_place *place, struct err *err) {
    char text[FOLDFREE_TEXT_MAX];
    if (!describe(p, 1, verdict, place, text, err) ||
        !jacobian_path_sign(p, f->room, 0, 0, &verdict, place, err))
        return false;
    return err_set(err, ERR_REFUSAL, "%s%s", text,
                   verdict == JACOBIAN_CERTIFIED ? "" : "; so it was before the edit");
}

bool foldfree_check(const struct foldfree *f, struct err *err) {
    struct jacobian_path path;
    struct least_place place;
    bool ok = true;
    least_place_init(&place);
    for (size_t i = 0; ok && i < f->count * (size_t)kinds(f); i++) {
        enum jacobian_verdict verdict;
        path_of(f, i, &path);
        ok = jacobian_path_sign(&path, f->room, 1, 1, &verdict, &place, err) &&
             (verdict == JACOBIAN_CERTIFIED || refuse(f, &path, verdict, &place, err));
    }
    least_place_free(&place);
    return ok;
}

bool foldfree_find_exit(const struct foldfree *f, struct foldfree_exit *exit, struct err *err) {
    struct jacobian_path path;
    struct least_place place;
    bool ok = true;
    *exit = (struct foldfree_exit){.share = 1};
    least_place_init(&place);
    for (size_t i = 0; ok && exit->share > 0 && i < f->count * (size_t)kinds(f); i++) {
        struct jacobian_exit own;
        path_of(f, i, &path);
        ok = jacobian_path_exit(&path, f->room, exit->share, &own, &place, err);
        if (!ok || own.verdict == JACOBIAN_CERTIFIED) continue;
        exit->share = own.held;
        exit->lost = own.lost;
        ok = describe(&path, own.lost, own.verdict, &place, exit->text, err);
    }
    least_place_free(&place);
    if (!ok || exit->share > 0) return ok;
    if (exit->lost == 0)
        return err_set(err, ERR_REFUSAL, "%s; so it was before the edit", exit->text);
    return err_set(err, ERR_REFUSAL, "%s after no more than %s of the edit", exit->text,
                   number(exit->lost).text);
}
