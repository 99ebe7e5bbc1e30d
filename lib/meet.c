/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Three questions lead to each other, of pieces a and b:
 *
 *     single(a)      monotone, or  single(a0), single(a1), joined(a0, a1)
 *     joined(a, b)   monotone together, or  joined(a1, b0), apart(a0, b0), apart(a0, b1),
 *                    apart(a1, b1)
 *     apart(a, b)    apart, or cross, or  apart of the halves of the larger one and the other
 *
 *          a0      a1   b0      b1          Pieces that are to lie apart have no parameter in
 *     |---------|----|----|---------|       common, so where they meet, two points do.
 *
 * Where pieces have become so small that the errors of doubles show, or there were too many, the
 * same questions go on in integers. There a crossing is sought in a wider window, each piece with
 * both its neighbours, so that one that lies where pieces meet is found, too. */
#include "meet_exact.h"

#include <math.h>

enum {
    STEPS = 20000,        /* pairs in doubles */
    FINE = 10,            /* levels of pieces that are nearly straight */
    FINEST = 50,          /* levels in doubles */
    ERRORS_PER_PIECE = 16 /* smaller ones are mostly errors */
};

void meet_init(struct meet *m) {
    m->verdict = MEET_NOT;
    m->distance = INFINITY;
    mpq_inits(m->lo[0], m->lo[1], m->hi[0], m->hi[1], NULL);
}

void meet_free(struct meet *m) {
    mpq_clears(m->lo[0], m->lo[1], m->hi[0], m->hi[1], NULL);
}

struct search {
    int d;
    enum meet_pair pair;
    const double (*q[2])[2];
    const struct meet_rule *rule;
    struct meet *m;
    int steps;
    bool has_exact; /* integers come in when they are needed */
    struct meet_exact exact;
};

static struct meet_exact *exact(struct search *s) {
    if (!s->has_exact) meet_exact_init(&s->exact, s->d, s->q[0], s->q[1], s->pair, s->rule, s->m);
    s->has_exact = true;
    return &s->exact;
}

static bool is_over(const struct search *s) {
    return s->m->verdict >= MEET_CROSS || (s->m->verdict != MEET_NOT && s->rule->parts == 0);
}

/* Doubles do not decide this. */
static void leave(struct search *s, enum meet_pair question, const struct meet_pieces *pieces) {
    if (s->rule->parts > 0)
        meet_exact_ask(exact(s), question, pieces);
    else
        s->m->verdict = MEET_UNDECIDED;
}

static struct meet_pieces pieces_of(const struct arc *a, const struct arc *b) {
    return (struct meet_pieces){{a->level, b->level}, {a->index, b->index}};
}

/* True if doubles have done what they can: then the question is left to integers. Pieces without
 * width beyond the errors would be seen to be apart, or to cross, if anything could be seen; those
 * that follow one another may still turn out to be monotone while they have a direction. */
static bool is_left(struct search *s, enum meet_pair question, const struct arc *a,
                    const struct arc *b) {
    int level = a->level > b->level ? a->level : b->level;
    struct meet_pieces pieces = pieces_of(a, b);
    double size = question == MEET_APART ? fmax(arc_width(s->d, a), arc_width(s->d, b))
                                         : fmax(arc_size(s->d, a), arc_size(s->d, b));
    if (s->steps++ < STEPS && level < FINEST && size > ERRORS_PER_PIECE * arc_error(s->d, level))
        return false;
    leave(s, question, &pieces);
    return true;
}

/* A crossing of large pieces is proved again by smaller ones, if it can be, which say better where
 * it is. */
static void apart(struct search *s, const struct arc *a, const struct arc *b) {
    struct arc half[2];
    bool cross, first;
    if (is_over(s) || arc_apart(s->d, a, b)) return;
    cross = arc_cross(s->d, a, b);
    if (!(cross && a->level + b->level >= 2 * FINE) && !is_left(s, MEET_APART, a, b)) {
        first = arc_size(s->d, a) >= arc_size(s->d, b);
        arc_halve(s->d, first ? a : b, half);
        for (int h = 0; h < 2; h++) apart(s, first ? &half[h] : a, first ? b : &half[h]);
    }
    if (cross && s->m->verdict < MEET_CROSS) {
        struct meet_pieces pieces = pieces_of(a, b);
        meet_exact_refine(exact(s), &pieces);
    }
}

static void joined(struct search *s, const struct arc *a, const struct arc *b) {
    struct arc ha[2], hb[2];
    if (is_over(s) || arc_monotone(s->d, a, b) || is_left(s, MEET_JOINED, a, b)) return;
    arc_halve(s->d, a, ha);
    arc_halve(s->d, b, hb);
    joined(s, &ha[1], &hb[0]);
    apart(s, &ha[0], &hb[0]);
    apart(s, &ha[0], &hb[1]);
    apart(s, &ha[1], &hb[1]);
}

static void single(struct search *s, const struct arc *a) {
    struct arc half[2];
    if (is_over(s) || arc_monotone(s->d, a, NULL) || is_left(s, MEET_SELF, a, a)) return;
    arc_halve(s->d, a, half);
    single(s, &half[0]);
    single(s, &half[1]);
    joined(s, &half[0], &half[1]);
}

void meet_arcs(int d, const double (*a)[2], const double (*b)[2], enum meet_pair pair,
               const struct meet_rule *rule, struct meet *m) {
    struct search s = {.d = d, .pair = pair, .q = {a, b}, .rule = rule, .m = m};
    struct arc pa, pb;
    m->verdict = MEET_NOT;
    m->distance = INFINITY;
    if (!arc_load(d, a, b, &pa, &pb))
        leave(&s, pair, &(struct meet_pieces){{0, 0}, {0, 0}});
    else if (pair == MEET_SELF)
        single(&s, &pa);
    else if (pair == MEET_JOINED)
        joined(&s, &pa, &pb);
    else
        apart(&s, &pa, &pb);
    if (s.has_exact) meet_exact_free(&s.exact);
}
