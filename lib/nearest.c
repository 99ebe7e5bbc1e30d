/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plane is cut into cells, about POINTS_PER_CELL points each; the outermost cells reach to
 * infinity, so that the box they are laid over need not hold all points. A search looks at the
 * query's cell, then at rings of cells around it:
 *
 *     +----+----+----+----+----+      What lies beyond ring 1 is farther from q than the nearest
 *     |    |    |    |    |    |      of the four lines that bound ring 1; sides where the cells
 *     |    | 1  | 1  | 1  |    |      end have no such line. The search stops when the best point
 *     |    | 1  | q  | 1  |    |      is nearer than that, or no cells are left.
 *     |    | 1  | 1  | 1  |    |
 *
 * The cell of a point is a rounded but monotone function of its coordinates. SLACK covers the
 * rounding: bounds are used a little smaller than computed, and never larger than the truth.
 *
 * The box is taken from a sample without its outermost points, since a single far point would
 * otherwise leave the others in one cell. After `count` moves the cells are laid out anew. */
#include "nearest.h"

#include "mem.h"

#include <math.h>

enum { POINTS_PER_CELL = 4, SAMPLE = 1024, CELLS_MAX = 1 << 14 };
#define SLACK          0x1p-30 /* absolute, in cells, and relative to the query's coordinate: */
#define SLACK_RELATIVE 0x1p-48

/* The cell coordinate c of x, within 0..cells-1. */
static uint32_t clamp_cell(const struct nearest *n, int c, double x) {
    double u = (x - n->origin[c]) * n->scale[c];
    if (!(u > 0)) return 0;
    return u < n->cells[c] - 1 ? (uint32_t)u : n->cells[c] - 1;
}

static uint32_t cell_of(const struct nearest *n, const double xy[2]) {
    return clamp_cell(n, 1, xy[1]) * n->cells[0] + clamp_cell(n, 0, xy[0]);
}

static void link_point(struct nearest *n, uint32_t p) {
    uint32_t cell = cell_of(n, n->at[p]), first = n->head[cell];
    n->cell[p] = cell;
    n->prev[p] = NEAREST_NONE;
    n->next[p] = first;
    if (first != NEAREST_NONE) n->prev[first] = p;
    n->head[cell] = p;
}

static void unlink_point(struct nearest *n, uint32_t p) {
    uint32_t prev = n->prev[p], next = n->next[p];
    if (prev == NEAREST_NONE)
        n->head[n->cell[p]] = next;
    else
        n->next[prev] = next;
    if (next != NEAREST_NONE) n->prev[next] = prev;
}

static int compare_doubles(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The range of coordinate c that holds all points but, perhaps, some at either end. */
static void sample_range(const struct nearest *n, int c, double *lo, double *width) {
    double sample[SAMPLE];
    uint32_t step = n->count / SAMPLE + 1, size = 0, cut;
    for (uint32_t p = 0; p < n->count && size < SAMPLE; p += step) sample[size++] = n->at[p][c];
    qsort(sample, size, sizeof *sample, compare_doubles);
    cut = size / 64;
    *lo = sample[cut];
    *width = sample[size - 1 - cut] - sample[cut];
    *lo -= *width / 16;
    *width += *width / 8;
}

static uint32_t limit_cells(double want, uint32_t max) {
    if (!(want > 1)) return 1;
    return want < max ? (uint32_t)want : max;
}

/* Lays out the cells, at most cell_limit of them. */
static void lay_out(struct nearest *n, uint32_t cell_limit) {
    double lo[2], width[2], larger;
    int exponent = 0;
    for (int c = 0; c < 2; c++) sample_range(n, c, &lo[c], &width[c]);
    larger = width[0] > width[1] ? width[0] : width[1];
    if (larger > 0 && larger < INFINITY) frexp(larger, &exponent);
    if (exponent < -1000) exponent = -1000; /* 2^-exponent must be a double */
    n->unit = ldexp(1, -exponent);
    n->cells[0] = limit_cells(sqrt((double)cell_limit * (width[0] / width[1])), cell_limit);
    if (n->cells[0] > CELLS_MAX) n->cells[0] = CELLS_MAX;
    n->cells[1] = limit_cells((double)cell_limit / n->cells[0], CELLS_MAX);
    for (int c = 0; c < 2; c++) {
        double scale = n->cells[c] / width[c];
        bool usable = scale > 0 && scale < 1e300; /* not where width is 0, tiny or infinite */
        n->origin[c] = lo[c];
        n->scale[c] = usable ? scale : 0;
        if (!usable) n->cells[c] = 1;
    }
}

static uint32_t cell_limit(const struct nearest *n) {
    return n->count / POINTS_PER_CELL + 1;
}

static void fill(struct nearest *n) {
    lay_out(n, cell_limit(n));
    n->moved = 0;
    for (uint32_t c = 0; c < n->cells[0] * n->cells[1]; c++) n->head[c] = NEAREST_NONE;
    for (uint32_t p = n->count; p-- > 0;) link_point(n, p);
}

bool nearest_init(struct nearest *n, const double (*at)[2], uint32_t count, struct err *err) {
    *n = (struct nearest){.at = at, .count = count};
    if (mem_new(n->head, cell_limit(n), err) && mem_new(n->cell, count, err) &&
        mem_new(n->next, count, err) && mem_new(n->prev, count, err)) {
        if (count > 0) fill(n);
        return true;
    }
    nearest_free(n);
    return false;
}

void nearest_free(struct nearest *n) {
    free(n->head);
    free(n->cell);
    free(n->next);
    free(n->prev);
    *n = (struct nearest){0};
}

void nearest_moved(struct nearest *n, uint32_t p) {
    if (++n->moved > n->count) {
        fill(n);
        return;
    }
    if (cell_of(n, n->at[p]) == n->cell[p]) return;
    unlink_point(n, p);
    link_point(n, p);
}

struct search {
    const struct nearest *n;
    const double *xy;
    uint32_t centre[2];
    uint32_t best;
    double best_d2;
};

static void search_cell(struct search *s, uint32_t x, uint32_t y) {
    const struct nearest *n = s->n;
    uint32_t p = n->head[y * n->cells[0] + x];
    for (; p != NEAREST_NONE; p = n->next[p]) {
        double dx = (n->at[p][0] - s->xy[0]) * n->unit, dy = (n->at[p][1] - s->xy[1]) * n->unit;
        double d2 = dx * dx + dy * dy;
        if (d2 < s->best_d2 || (d2 == s->best_d2 && p < s->best)) {
            s->best = p;
            s->best_d2 = d2;
        }
    }
}

/* Cells at distance r (in the maximum norm) from the centre. */
static void search_ring(struct search *s, uint32_t r) {
    int64_t cx = s->centre[0], cy = s->centre[1], nx = s->n->cells[0], ny = s->n->cells[1];
    int64_t x0 = cx < r ? 0 : cx - r, x1 = cx + r < nx ? cx + r : nx - 1;
    int64_t y0 = cy < r ? 0 : cy - r, y1 = cy + r < ny ? cy + r : ny - 1;
    for (int64_t y = y0; y <= y1; y++) {
        bool whole = y == cy - r || y == cy + r;
        if (whole)
            for (int64_t x = x0; x <= x1; x++) search_cell(s, (uint32_t)x, (uint32_t)y);
        else {
            if (cx - r >= 0) search_cell(s, (uint32_t)(cx - r), (uint32_t)y);
            if (cx + r < nx) search_cell(s, (uint32_t)(cx + r), (uint32_t)y);
        }
    }
}

/* A gap of g cells in scaled world units; 0 if it is in doubt (NaN from overflow). */
static double gap(double g, double unit) {
    return g > 0 ? g * unit : 0;
}

/* A lower bound of the scaled distance from the query to points beyond ring r; INFINITY if all
 * cells lie within it. */
static double beyond(const struct search *s, uint32_t r) {
    const struct nearest *n = s->n;
    double bound = INFINITY;
    for (int c = 0; c < 2; c++) {
        double u = (s->xy[c] - n->origin[c]) * n->scale[c],
               slack = SLACK + SLACK_RELATIVE * fabs(u);
        double to_world = n->unit / n->scale[c];
        int64_t low = (int64_t)s->centre[c] - r, high = (int64_t)s->centre[c] + r + 1;
        if (low > 0) bound = fmin(bound, gap(u - (double)low - slack, to_world));
        if (high < n->cells[c]) bound = fmin(bound, gap((double)high - u - slack, to_world));
    }
    return bound;
}

uint32_t nearest_find(const struct nearest *n, const double xy[2]) {
    struct search s = {.n = n, .xy = xy, .best = NEAREST_NONE, .best_d2 = INFINITY};
    if (n->count == 0) return NEAREST_NONE;
    for (int c = 0; c < 2; c++) s.centre[c] = clamp_cell(n, c, xy[c]);
    for (uint32_t r = 0;; r++) {
        double bound;
        search_ring(&s, r);
        bound = beyond(&s, r);
        if (bound == INFINITY || bound * bound > s.best_d2) return s.best;
    }
}

void nearest_box(const struct nearest *n, const double lo[2], const double hi[2],
                 void (*visit)(void *context, uint32_t p), void *context) {
    uint32_t from[2], to[2];
    if (n->count == 0) return;
    for (int c = 0; c < 2; c++) {
        from[c] = clamp_cell(n, c, lo[c]);
        to[c] = clamp_cell(n, c, hi[c]);
    }
    for (uint32_t y = from[1]; y <= to[1]; y++)
        for (uint32_t x = from[0]; x <= to[0]; x++)
            for (uint32_t p = n->head[y * n->cells[0] + x]; p != NEAREST_NONE; p = n->next[p])
                if (n->at[p][0] >= lo[0] && n->at[p][0] <= hi[0] && n->at[p][1] >= lo[1] &&
                    n->at[p][1] <= hi[1])
                    visit(context, p);
}
