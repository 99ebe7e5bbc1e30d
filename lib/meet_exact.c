/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "meet_exact.h"

#include "rational.h"

#include <math.h>

enum {
    LEVELS_MAX = 1024,
    REFINED = 40 /* intervals of a crossing become at most 2^-40 long, if it can be */
};

/* lo .. hi over 2^level */
struct span {
    mpz_t lo, hi;
    unsigned level;
};

/* One question: two spans, and their pieces at a common scale. */
struct node {
    struct span span[2];
    struct arc_integers piece[2];
    unsigned scale; /* integers are 2^scale times those of the whole arcs */
};

static void node_init(struct node *n) {
    for (int i = 0; i < 2; i++) {
        mpz_inits(n->span[i].lo, n->span[i].hi, NULL);
        arc_integers_init(&n->piece[i]);
    }
}

static void node_free(struct node *n) {
    for (int i = 0; i < 2; i++) {
        mpz_clears(n->span[i].lo, n->span[i].hi, NULL);
        arc_integers_free(&n->piece[i]);
    }
}

/* Half h of a span. */
static void halve(const struct span *s, int h, struct span *half) {
    half->level = s->level + 1;
    mpz_add(half->lo, s->lo, h == 0 ? s->lo : s->hi);
    mpz_add(half->hi, s->hi, h == 0 ? s->lo : s->hi);
}

static void load(const struct meet_exact *x, struct node *n) {
    unsigned level = n->span[0].level > n->span[1].level ? n->span[0].level : n->span[1].level;
    n->scale = level * (unsigned)x->d;
    for (int i = 0; i < 2; i++)
        arc_integers_piece(x->d, &x->whole[i], n->span[i].lo, n->span[i].hi, n->span[i].level,
                           n->scale, &n->piece[i]);
}

/* The largest difference of a coordinate within n points. */
static void widen_extent(int n, mpz_t (*c)[2], mpz_t extent) {
    mpz_t difference;
    mpz_init(difference);
    for (int axis = 0; axis < 2; axis++) {
        int lo = 0, hi = 0;
        for (int i = 1; i < n; i++) {
            if (mpz_cmp(c[i][axis], c[lo][axis]) < 0) lo = i;
            if (mpz_cmp(c[i][axis], c[hi][axis]) > 0) hi = i;
        }
        mpz_sub(difference, c[hi][axis], c[lo][axis]);
        if (mpz_cmp(difference, extent) > 0) mpz_set(extent, difference);
    }
    mpz_clear(difference);
}

void meet_exact_init(struct meet_exact *x, int d, const double (*a)[2], const double (*b)[2],
                     enum meet_pair pair, const struct meet_rule *rule, struct meet *m) {
    mpq_t fraction;
    *x = (struct meet_exact){.d = d, .pair = pair, .rule = rule, .m = m};
    for (int i = 0; i < 2; i++) arc_integers_init(&x->whole[i]);
    x->exponent = arc_integers_load(d, a, b, &x->whole[0], &x->whole[1]);
    mpz_init(x->near);
    for (int i = 0; i < 2; i++) widen_extent(d + 1, x->whole[i].c, x->near);
    mpq_init(fraction);
    mpq_set_d(fraction, rule->undecided);
    x->cut = mpz_scan1(mpq_denref(fraction), 0);
    mpz_mul(x->near, x->near, mpq_numref(fraction));
    mpq_clear(fraction);
}

void meet_exact_free(struct meet_exact *x) {
    for (int i = 0; i < 2; i++) arc_integers_free(&x->whole[i]);
    mpz_clear(x->near);
}

static bool is_over(const struct meet_exact *x) {
    return x->m->verdict >= MEET_CROSS;
}

static void set_fraction(mpq_t q, const mpz_t n, unsigned level) {
    mpq_set_z(q, n);
    mpq_div_2exp(q, q, level);
}

static void record(struct meet_exact *x, enum meet_verdict verdict, const struct node *n) {
    for (int i = 0; i < 2; i++) {
        set_fraction(x->m->lo[i], n->span[i].lo, n->span[i].level);
        set_fraction(x->m->hi[i], n->span[i].hi, n->span[i].level);
    }
    x->m->verdict = verdict;
}

/* sqrt(dx^2 + dy^2) times 2^exponent, rounded up. */
static double length_of(const mpz_t dx, const mpz_t dy, int exponent) {
    enum { MORE = 64 };
    double length;
    mpz_t sum;
    mpq_t q;
    mpz_init(sum);
    mpq_init(q);
    mpz_mul(sum, dx, dx);
    mpz_addmul(sum, dy, dy);
    mpz_mul_2exp(sum, sum, 2 * MORE);
    mpz_sqrt(sum, sum);
    mpz_add_ui(sum, sum, 1);
    mpq_set_z(q, sum);
    exponent -= MORE;
    if (exponent < 0)
        mpq_div_2exp(q, q, (mp_bitcnt_t)-exponent);
    else
        mpq_mul_2exp(q, q, (mp_bitcnt_t)exponent);
    length = nextafter(rational_round(q), INFINITY);
    mpz_clear(sum);
    mpq_clear(q);
    return length;
}

/* The pieces' distance is at most that of these points: if that is the least so far, it is noted.
 * Of pieces that follow one another, the outer ends are taken: the others are one. */
static void note(struct meet_exact *x, enum meet_pair question, const struct node *n) {
    const mpz_t *a = (const mpz_t *)n->piece[0].c[0];
    const mpz_t *b = (const mpz_t *)n->piece[1].c[question == MEET_APART ? 0 : x->d];
    mpz_t difference[2];
    double distance;
    mpz_inits(difference[0], difference[1], NULL);
    for (int c = 0; c < 2; c++) mpz_sub(difference[c], a[c], b[c]);
    distance = length_of(difference[0], difference[1], x->exponent - (int)n->scale);
    if (x->m->verdict == MEET_NOT || distance < x->m->distance) {
        record(x, MEET_UNDECIDED, n);
        x->m->distance = distance;
    }
    mpz_clears(difference[0], difference[1], NULL);
}

static bool is_small(const struct meet_exact *x, struct node *n) {
    mpz_t near, extent;
    bool small;
    mpz_inits(near, extent, NULL);
    mpz_mul_2exp(near, x->near, n->scale);
    mpz_fdiv_q_2exp(near, near, x->cut);
    for (int i = 0; i < 2; i++) widen_extent(x->d + 1, n->piece[i].c, extent);
    small = mpz_cmp(extent, near) <= 0;
    mpz_clears(near, extent, NULL);
    return small;
}

/* Does an end of one piece coincide with one of the other? */
static bool find_common_end(struct meet_exact *x, const struct node *n) {
    for (int i = 0; i < 4; i++) {
        const mpz_t *a = (const mpz_t *)n->piece[0].c[i & 1 ? x->d : 0];
        const mpz_t *b = (const mpz_t *)n->piece[1].c[i & 2 ? x->d : 0];
        if (mpz_cmp(a[0], b[0]) != 0 || mpz_cmp(a[1], b[1]) != 0) continue;
        record(x, MEET_POINT, n);
        for (int k = 0; k < 2; k++)
            if (i >> k & 1)
                mpq_set(x->m->lo[k], x->m->hi[k]);
            else
                mpq_set(x->m->hi[k], x->m->lo[k]);
        return true;
    }
    return false;
}

/* Do the arcs meet at the simplest fractions within the spans? */
static bool find_simple_point(struct meet_exact *x, const struct node *n) {
    mpq_t lo, hi, t[2], point[2][2];
    bool same;
    mpq_inits(lo, hi, t[0], t[1], NULL);
    for (int i = 0; i < 2; i++) {
        mpq_inits(point[i][0], point[i][1], NULL);
        set_fraction(lo, n->span[i].lo, n->span[i].level);
        set_fraction(hi, n->span[i].hi, n->span[i].level);
        rational_simplest(lo, hi, t[i]);
        arc_exact_point(x->d, &x->whole[i], t[i], point[i]);
    }
    same = mpq_equal(point[0][0], point[1][0]) && mpq_equal(point[0][1], point[1][1]);
    if (same) {
        x->m->verdict = MEET_POINT;
        for (int i = 0; i < 2; i++) {
            mpq_set(x->m->lo[i], t[i]);
            mpq_set(x->m->hi[i], t[i]);
        }
    }
    mpq_clears(lo, hi, t[0], t[1], NULL);
    for (int i = 0; i < 2; i++) mpq_clears(point[i][0], point[i][1], NULL);
    return same;
}

/* A span of one unit, and its neighbours within the arc. */
static void set_window(const struct span *s, struct span *window) {
    mpz_t end;
    mpz_init_set_ui(end, 1);
    mpz_mul_2exp(end, end, s->level);
    window->level = s->level;
    mpz_sub_ui(window->lo, s->lo, mpz_sgn(s->lo) > 0);
    mpz_add_ui(window->hi, s->hi, mpz_cmp(s->hi, end) < 0);
    mpz_clear(end);
}

/* Have the windows a point of the arcs' parameters in common? */
static bool share_a_place(const struct meet_exact *x, const struct node *window) {
    mpq_t a, b;
    bool share = false;
    mpq_inits(a, b, NULL);
    set_fraction(a, window->span[0].hi, window->span[0].level);
    set_fraction(b, window->span[1].lo, window->span[1].level);
    if (x->pair == MEET_JOINED) share = mpq_cmp_ui(a, 1, 1) == 0 && mpq_sgn(b) == 0;
    if (x->pair == MEET_SELF) share = mpq_cmp(a, b) >= 0;
    mpq_clears(a, b, NULL);
    return share;
}

static bool cross(const struct meet_exact *x, struct node *n) {
    load(x, n);
    return arc_exact_cross(x->d, &n->piece[0], &n->piece[1]);
}

/* The middle half of a window, or the first, or the last; the same for the other. */
static const int thirds[9][2] = {{1, 1}, {0, 1}, {2, 1}, {1, 0}, {1, 2},
                                 {0, 0}, {2, 0}, {0, 2}, {2, 2}};

static bool shorten(const struct meet_exact *x, struct node *n, struct node *part) {
    mpz_t step;
    mpz_init(step);
    for (int k = 0; k < 9; k++) {
        for (int i = 0; i < 2; i++) {
            struct span *to = &part->span[i], *from = &n->span[i];
            mpz_sub(step, from->hi, from->lo);
            to->level = from->level + 2;
            mpz_mul_2exp(to->lo, from->lo, 2);
            mpz_addmul_ui(to->lo, step, (unsigned long)thirds[k][i]);
            mpz_mul_2exp(step, step, 1);
            mpz_add(to->hi, to->lo, step);
        }
        if (!cross(x, part)) continue;
        mpz_clear(step);
        return true;
    }
    mpz_clear(step);
    return false;
}

/* n holds windows that cross. */
static void refine(struct meet_exact *x, struct node *n) {
    struct node part;
    node_init(&part);
    for (int k = 0; k < REFINED && shorten(x, n, &part); k++)
        for (int i = 0; i < 2; i++) {
            mpz_swap(n->span[i].lo, part.span[i].lo);
            mpz_swap(n->span[i].hi, part.span[i].hi);
            n->span[i].level = part.span[i].level;
        }
    record(x, MEET_CROSS, n);
    (void)find_simple_point(x, n);
    node_free(&part);
}

static bool find_crossing(struct meet_exact *x, const struct node *n) {
    struct node window;
    bool found;
    node_init(&window);
    for (int i = 0; i < 2; i++) set_window(&n->span[i], &window.span[i]);
    if (share_a_place(x, &window))
        for (int i = 0; i < 2; i++) {
            mpz_set(window.span[i].lo, n->span[i].lo);
            mpz_set(window.span[i].hi, n->span[i].hi);
        }
    found = cross(x, &window);
    if (found) refine(x, &window);
    node_free(&window);
    return found;
}

static void ask(struct meet_exact *x, enum meet_pair question, struct node *n);

static void ask_halves(struct meet_exact *x, enum meet_pair question, const struct node *n, int a,
                       int b) {
    struct node half;
    if (is_over(x)) return;
    node_init(&half);
    halve(&n->span[0], a, &half.span[0]);
    halve(&n->span[1], b, &half.span[1]);
    ask(x, question, &half);
    node_free(&half);
}

/* Half h of piece i, and the other. */
static void ask_half(struct meet_exact *x, const struct node *n, int i, int h) {
    struct node half;
    if (is_over(x)) return;
    node_init(&half);
    halve(&n->span[i], h, &half.span[i]);
    mpz_set(half.span[1 - i].lo, n->span[1 - i].lo);
    mpz_set(half.span[1 - i].hi, n->span[1 - i].hi);
    half.span[1 - i].level = n->span[1 - i].level;
    ask(x, MEET_APART, &half);
    node_free(&half);
}

static bool first_is_larger(const struct meet_exact *x, struct node *n) {
    mpz_t size[2];
    bool larger;
    for (int i = 0; i < 2; i++) {
        mpz_init(size[i]);
        widen_extent(x->d + 1, n->piece[i].c, size[i]);
    }
    larger = mpz_cmp(size[0], size[1]) >= 0;
    for (int i = 0; i < 2; i++) mpz_clear(size[i]);
    return larger;
}

static bool settled(struct meet_exact *x, enum meet_pair question, struct node *n) {
    const struct arc_integers *a = &n->piece[0], *b = &n->piece[1];
    switch (question) {
    case MEET_SELF:
        return arc_exact_monotone(x->d, a, NULL);
    case MEET_JOINED:
        return arc_exact_monotone(x->d, a, b);
    case MEET_APART:
        return arc_exact_apart(x->d, a, b) || find_common_end(x, n) || find_crossing(x, n);
    }
    return false;
}

static void ask(struct meet_exact *x, enum meet_pair question, struct node *n) {
    if (x->parts >= x->rule->parts && x->m->verdict != MEET_NOT) return;
    load(x, n);
    x->parts++;
    if (settled(x, question, n)) return;
    if (is_small(x, n) || n->span[0].level > LEVELS_MAX || x->parts >= x->rule->parts) {
        if (question != MEET_APART || !find_simple_point(x, n)) note(x, question, n);
        return;
    }
    if (question == MEET_APART) {
        int larger = first_is_larger(x, n) ? 0 : 1;
        for (int h = 0; h < 2; h++) ask_half(x, n, larger, h);
    } else if (question == MEET_JOINED) {
        ask_halves(x, MEET_JOINED, n, 1, 0);
        ask_halves(x, MEET_APART, n, 0, 0);
        ask_halves(x, MEET_APART, n, 0, 1);
        ask_halves(x, MEET_APART, n, 1, 1);
    } else {
        ask_halves(x, MEET_SELF, n, 0, 0);
        ask_halves(x, MEET_SELF, n, 1, 1);
        ask_halves(x, MEET_JOINED, n, 0, 1);
    }
}

static void set_node(struct node *n, const struct meet_pieces *pieces) {
    for (int i = 0; i < 2; i++) {
        mpz_set_ui(n->span[i].lo, pieces->index[i]);
        mpz_set_ui(n->span[i].hi, pieces->index[i] + 1);
        n->span[i].level = (unsigned)pieces->level[i];
    }
}

void meet_exact_ask(struct meet_exact *x, enum meet_pair question,
                    const struct meet_pieces *pieces) {
    struct node n;
    if (is_over(x)) return;
    node_init(&n);
    set_node(&n, pieces);
    ask(x, question, &n);
    node_free(&n);
}

void meet_exact_refine(struct meet_exact *x, const struct meet_pieces *pieces) {
    struct node n;
    node_init(&n);
    set_node(&n, pieces);
    refine(x, &n);
    node_free(&n);
}
