/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cages.h"

#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TURN 6.283185307179586

static void begin(struct cage_pair *p, const char *name, size_t n, double stretch) {
    *p = (struct cage_pair){.name = name, .count = n, .stretch = stretch, .back = 1e-12};
    p->source = calloc(n, sizeof *p->source);
    p->target = calloc(n, sizeof *p->target);
    assert_true(p->source && p->target);
}

static void polar(double at[2], double radius, double angle) {
    at[0] = radius * cos(angle);
    at[1] = radius * sin(angle);
}

static void circle(double (*at)[2], size_t n) {
    for (size_t i = 0; i < n; i++) polar(at[i], 1, TURN * (double)i / (double)n);
}

static void rectangle(double (*at)[2], double width, double height) {
    const double box[4][2] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    memcpy(at, box, sizeof box);
}

/* Each side of a square in n/4 parts. */
static void square(double (*at)[2], size_t n) {
    for (size_t i = 0; i < n; i++) {
        double s = (double)(i % (n / 4)) / (double)(n / 4);
        const double way[4][2] = {{s, 0}, {1, s}, {1 - s, 1}, {0, 1 - s}};
        memcpy(at[i], way[i / (n / 4)], sizeof *at);
    }
}

/* 12 vertices; the bridge between the two halves is 2 half wide. */
static void dumbbell(double (*at)[2], double half) {
    const double d[12][2] = {{0, 0}, {1, 0}, {1, 0.5 - half}, {2, 0.5 - half}, {2, 0}, {3, 0},
                             {3, 1}, {2, 1}, {2, 0.5 + half}, {1, 0.5 + half}, {1, 1}, {0, 1}};
    memcpy(at, d, sizeof d);
}

/* 4 teeth vertices, teeth as high as `up`, gaps as deep as 0. */
static void comb(double (*at)[2], int teeth, double up) {
    size_t n = 0;
    const double base[2][2] = {{0, -1}, {2 * teeth - 1, -1}};
    memcpy(at, base, sizeof base);
    for (int i = teeth - 1; i >= 0; i--) {
        const double tooth[4][2] = {
            {2 * i + 1, up}, {2 * i, up}, {2 * i, 0}, {2 * i - 1, 0}}; /* and the gap before it */
        memcpy(at[2 + n], tooth, (i ? 4 : 2) * sizeof *tooth);
        n += 4;
    }
}

/* 2 (m + 1) vertices: out on the one side, back on the other. */
static void spiral(double (*at)[2], size_t m) {
    for (size_t i = 0; i <= m; i++) {
        double angle = 4 * TURN * (double)i / (double)m, radius = 0.2 + angle / TURN;
        polar(at[i], radius + 0.15, angle);
        polar(at[2 * m + 1 - i], radius - 0.15, angle);
    }
}

static void bar(double (*at)[2], size_t m) {
    for (size_t i = 0; i <= m; i++) {
        at[i][0] = at[2 * m + 1 - i][0] = 10 * (double)i / (double)m;
        at[2 * m + 1 - i][1] = 1;
    }
}

static void make_round(struct cage_pair *p, int i) {
    static const double sharp[4][2] = {{0, 0}, {10, 0.3}, {1, 1}, {0.3, 5}};
    switch (i) {
    case 0:
        begin(p, "square to a sharp quadrilateral", 4, 1e2);
        rectangle(p->source, 1, 1);
        memcpy(p->target, sharp, sizeof sharp);
        return;
    case 1:
        begin(p, "circle to a star", 10, 1e2);
        circle(p->source, p->count);
        for (int k = 0; k < 10; k++) polar(p->target[k], k % 2 ? 0.15 : 1, TURN * k / 10);
        return;
    case 2:
        begin(p, "circle to a blob with three legs", 60, 1e2);
        circle(p->source, p->count);
        for (int k = 0; k < 60; k++)
            polar(p->target[k], 1 + 0.7 * cos(3 * TURN * k / 60), TURN * k / 60);
        return;
    case 3:
        begin(p, "collinear vertices to a circle", 100, 1e2);
        square(p->source, 100);
        circle(p->target, 100);
        return;
    case 4:
        begin(p, "circle to collinear vertices", 100, 1e2);
        circle(p->source, 100);
        square(p->target, 100);
        return;
    default:
        begin(p, "triangle to a needle", 3, 1e4);
        p->source[1][0] = p->source[2][1] = p->target[2][1] = 1;
        p->target[1][0] = 1000;
    }
}

static void make_strip(struct cage_pair *p, int i) {
    static const double tilted[4][2] = {{0, 0}, {300, 400}, {299.2, 400.6}, {-0.8, 0.6}};
    begin(p,
          (const char *[]){"strip of 1:500 to a square", "square to a strip of 1:500",
                           "tilted strip to a square", "strip far thinner than points"}[i],
          4, (const double[]){1e4, 1e4, 1e4, 1e13}[i]);
    if (i == 0) rectangle(p->source, 500, 1), rectangle(p->target, 1, 1);
    if (i == 1) rectangle(p->source, 1, 1), rectangle(p->target, 500, 1);
    if (i == 2) memcpy(p->source, tilted, sizeof tilted), rectangle(p->target, 1, 1);
    if (i == 3) rectangle(p->source, 1, 1e-12), rectangle(p->target, 1, 1);
}

static void make_neck(struct cage_pair *p, int i) {
    begin(p,
          (const char *[]){"dumbbell", "a neck of 1e-5 that opens", "a neck that closes to 1e-5",
                           "a neck of 1e-5 to a circle"}[i],
          12, i ? 1e6 : 1e2);
    if (i == 2) p->back = 1e-11;
    dumbbell(p->source, (const double[]){0.1, 5e-6, 0.4, 5e-6}[i]);
    dumbbell(p->target, (const double[]){0.4, 0.4, 5e-6, 0}[i]);
    if (i == 3) circle(p->target, 12);
}

static void make_comb(struct cage_pair *p, int i) {
    static const int teeth[] = {12, 250, 1000};
    begin(p,
          (const char *[]){"comb to a circle", "comb of 250 teeth to a circle",
                           "comb of 1,000 teeth, shortened"}[i],
          (size_t)teeth[i] * 4, i < 2 ? 1e4 : 1e7);
    comb(p->source, teeth[i], i ? 30 : 10);
    if (i < 2)
        circle(p->target, p->count);
    else {
        comb(p->target, teeth[i], 3);
        p->back = 1e-9;
    }
}

void cage_pair_make(struct cage_pair *p, int i) {
    if (i < 6)
        make_round(p, i);
    else if (i < 10)
        make_strip(p, i - 6);
    else if (i < 14)
        make_neck(p, i - 10);
    else if (i == 15) {
        begin(p, "spiral to a bar", 162, 1e4);
        spiral(p->source, 80);
        bar(p->target, 80);
    } else
        make_comb(p, i == 14 ? 0 : i - 15);
}

static double cross(const double a[2], const double b[2], const double c[2]) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static int do_cross(const double a[2], const double b[2], const double c[2], const double d[2]) {
    return cross(a, b, c) * cross(a, b, d) <= 0 && cross(c, d, a) * cross(c, d, b) <= 0;
}

/* Exchanging the ends of two sides that cross shortens the polygon, so this ends. */
static void untangle(double (*at)[2], size_t n) {
    for (int again = 1; again;) {
        again = 0;
        for (size_t i = 0; i + 2 < n; i++)
            for (size_t j = i + 2; j < n - (i == 0); j++) {
                if (!do_cross(at[i], at[i + 1], at[j], at[(j + 1) % n])) continue;
                again = 1;
                for (size_t a = i + 1, b = j; a < b; a++, b--) {
                    double t[2];
                    memcpy(t, at[a], sizeof t);
                    memcpy(at[a], at[b], sizeof t);
                    memcpy(at[b], t, sizeof t);
                }
            }
    }
}

static double area(const double (*at)[2], size_t n) {
    double sum = 0;
    for (size_t i = 2; i < n; i++) sum += cross(at[0], at[i - 1], at[i]);
    return sum;
}

static void turn(double (*to)[2], const double (*from)[2], size_t n, size_t shift, int reversed) {
    for (size_t i = 0; i < n; i++)
        memcpy(to[i], from[reversed ? (shift + n - i) % n : (shift + i) % n], sizeof *to);
}

static void random_polygon(double (*at)[2], size_t n, uint64_t *state) {
    double(*copy)[2] = calloc(n, sizeof *copy);
    assert_non_null(copy);
    for (size_t i = 0; i < n; i++)
        for (int k = 0; k < 2; k++) copy[i][k] = random_unit(state);
    untangle(copy, n);
    turn(at, (const double(*)[2])copy, n, 0, area((const double(*)[2])copy, n) < 0);
    free(copy);
}

void cage_pair_random(struct cage_pair *p, int low, int high, uint64_t seed) {
    uint64_t state = seed;
    begin(p, "random", (size_t)random_in(&state, low, high), 1e4);
    random_polygon(p->source, p->count, &state);
    random_polygon(p->target, p->count, &state);
}

void cage_pair_turn(struct cage_pair *p, const struct cage_pair *from, size_t shift, int reversed) {
    begin(p, from->name, from->count, from->stretch);
    turn(p->source, (const double(*)[2])from->source, p->count, shift, reversed);
    turn(p->target, (const double(*)[2])from->target, p->count, shift, reversed);
}

void cage_pair_free(struct cage_pair *p) {
    free(p->source);
    free(p->target);
    *p = (struct cage_pair){0};
}
