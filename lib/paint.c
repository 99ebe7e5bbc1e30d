/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Edge by edge and polygon by polygon:
 *
 *   - a segment paints the cells nearer than the radius. Strip by strip, the part of the segment in
 *     the dilated strip gives a range of columns; centre and radius of a cell decide most cases,
 * the distance to its sides the others;
 *
 *             strip   - - - - - - - - -
 *                     |  |  |  |/ |  |        radius above and below, left and right
 *                     - - - - / - - - -
 *   - a polygon also paints the cells within it that its edges left out. Those lie wholly inside or
 *     outside, so the winding number at one point in the middle decides; it comes from the
 *     crossings of the polygon with the middle line of the strip.
 *
 * Where painted cells meet at a vertex only, the smallest gap between them is filled. Squares and
 * triangles around a vertex lie so that this gap is within the rows and columns of the cells beside
 * it. */
#include "paint.h"

#include "mem.h"

#include <math.h>
#include <string.h>

struct crossing {
    double x;
    uint32_t row;
    int turn; /* +1: upwards */
};

static double smaller(double x, double y) {
    return x < y ? x : y;
}

static double larger(double x, double y) {
    return x > y ? x : y;
}

bool paint_init(struct paint *b, const struct pattern *pattern, double radius, struct err *err) {
    double tiny;
    *b = (struct paint){.pattern = pattern};
    b->low[0] = pattern->x[0];
    b->low[1] = pattern->y[0];
    b->width = (double)pattern->x[1] - pattern->x[0];
    b->height = (double)pattern->y[1] - pattern->y[0];
    b->reach = sqrt(b->width * b->width + b->height * b->height) / 2;
    tiny = b->width * 0x1p-30;
    b->radius = larger(radius - tiny, tiny);
    if (!mem_new(b->keep, (size_t)pattern->columns * pattern->ny, err) ||
        !mem_new(b->skip, (size_t)pattern->columns * pattern->ny, err)) {
        paint_free(b);
        return false;
    }
    return true;
}

void paint_free(struct paint *b) {
    free(b->keep);
    free(b->skip);
    free(b->crossing);
    *b = (struct paint){0};
}

static double square(double x) {
    return x * x;
}

/* Squared distance of p from the segment ab. */
static double distance2(const double p[2], const double a[2], const double b[2]) {
    double dx = b[0] - a[0], dy = b[1] - a[1], length2 = dx * dx + dy * dy;
    double t = length2 > 0 ? ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length2 : 0;
    if (t < 0) t = 0;
    if (t > 1) t = 1;
    return square(p[0] - a[0] - t * dx) + square(p[1] - a[1] - t * dy);
}

static double side_of(const double a[2], const double b[2], const double p[2]) {
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

static bool cross(const double a[2], const double b[2], const double c[2], const double d[2]) {
    return (side_of(a, b, c) > 0) != (side_of(a, b, d) > 0) &&
           (side_of(c, d, a) > 0) != (side_of(c, d, b) > 0);
}

/* Is the segment ab nearer than r to the convex polygon? */
static bool is_near(const double a[2], const double b[2], int n, const double (*corner)[2],
                    double r) {
    bool inside = true;
    for (int i = 0; i < n; i++) {
        const double *c = corner[i], *d = corner[(i + 1) % n];
        inside = inside && side_of(c, d, a) >= 0;
        if (cross(a, b, c, d) || distance2(a, c, d) < r * r || distance2(b, c, d) < r * r ||
            distance2(c, a, b) < r * r)
            return true;
    }
    return inside;
}

static void centre_of(const struct paint *b, double column, double row, double centre[2]) {
    bool hex = b->pattern->kind == PATTERN_HEX;
    centre[0] = hex ? column * b->width / 2 : (column + 0.5) * b->width;
    centre[1] = (row + 0.5) * b->height;
}

/* Is the segment pq, counted from the low corner, nearer to a cell than the radius? */
static bool meets(const struct paint *b, uint32_t column, uint32_t row, const double p[2],
                  const double q[2]) {
    double centre[2], corner[4][2], d2;
    int32_t lattice[4][2];
    int n;
    centre_of(b, column, row, centre);
    d2 = distance2(centre, p, q);
    if (d2 < square(b->radius)) return true;
    if (d2 >= square(b->radius + b->reach)) return false;
    n = pattern_cell(b->pattern, column, row, lattice);
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 2; c++) corner[i][c] = lattice[i][c] - b->low[c];
    return is_near(p, q, n, (const double(*)[2])corner, b->radius);
}

static uint32_t clamp(double x, uint32_t n) {
    return x < 0 ? 0 : x > n - 1 ? n - 1 : (uint32_t)x;
}

/* The range of x of the part of pq between y0 and y1. */
static void clip(const double p[2], const double q[2], double y0, double y1, double x[2]) {
    double dy = q[1] - p[1], t0 = 0, t1 = 1, xp, xq;
    if (dy != 0) {
        t0 = larger(0, smaller((y0 - p[1]) / dy, (y1 - p[1]) / dy));
        t1 = smaller(1, larger((y0 - p[1]) / dy, (y1 - p[1]) / dy));
    }
    xp = p[0] + t0 * (q[0] - p[0]);
    xq = p[0] + t1 * (q[0] - p[0]);
    x[0] = smaller(xp, xq);
    x[1] = larger(xp, xq);
}

/* The columns whose cells may meet x[0]..x[1]. */
static void columns_of(const struct paint *b, const double x[2], uint32_t range[2]) {
    bool hex = b->pattern->kind == PATTERN_HEX;
    double unit = hex ? b->width / 2 : b->width;
    range[0] = clamp(floor(x[0] / unit) - 1, b->pattern->columns);
    range[1] = clamp(floor(x[1] / unit) + 1, b->pattern->columns);
}

/* The first column >= c of a row that is not painted, or `columns`. Every cell on the way learns
 * how far it may skip, so a painted stretch costs O(1) on average, however often it is met. */
static uint32_t next_unpainted(struct paint *b, size_t row_start, uint32_t c) {
    uint32_t columns = b->pattern->columns, end = c;
    while (end < columns && b->keep[row_start + end]) end += 1 + b->skip[row_start + end];
    while (c < end) {
        uint32_t step = 1 + b->skip[row_start + c];
        b->skip[row_start + c] = end - c - 1;
        c += step;
    }
    return end;
}

/* The rows whose strips the radius may reach from low..high of y. */
static void rows_of(const struct paint *b, double low, double high, uint32_t range[2]) {
    range[0] = clamp(floor((low - b->radius) / b->height) - 1, b->pattern->ny);
    range[1] = clamp(floor((high + b->radius) / b->height) + 1, b->pattern->ny);
}

/* How far to the left and right of a piece at low..high of y the radius reaches in a strip;
 * negative where it does not reach the strip. */
static double half_width(const struct paint *b, double low, double high, uint32_t row) {
    double below = row * b->height - high, above = low - (row + 1) * b->height;
    double gap = larger(0, larger(below, above)), rest = square(b->radius) - square(gap);
    return rest < 0 ? -1 : sqrt(rest);
}

/* Paints the cells of a row near the segment pq. */
static void paint_row(struct paint *b, uint32_t row, const double p[2], const double q[2],
                      double wide) {
    size_t start = (size_t)row * b->pattern->columns;
    uint32_t range[2];
    double x[2];
    clip(p, q, row * b->height - b->radius, (row + 1) * b->height + b->radius, x);
    x[0] -= wide;
    x[1] += wide;
    columns_of(b, x, range);
    for (uint32_t c = next_unpainted(b, start, range[0]); c <= range[1];
         c = next_unpainted(b, start, c + 1))
        if (meets(b, c, row, p, q)) b->keep[start + c] = 1;
}

void paint_segment(struct paint *b, const double from[2], const double to[2]) {
    double p[2] = {from[0] - b->low[0], from[1] - b->low[1]};
    double q[2] = {to[0] - b->low[0], to[1] - b->low[1]};
    double low = smaller(p[1], q[1]), high = larger(p[1], q[1]);
    uint32_t rows[2];
    rows_of(b, low, high, rows);
    for (uint32_t row = rows[0]; row <= rows[1]; row++) {
        double wide = half_width(b, low, high, row);
        if (wide >= 0) paint_row(b, row, p, q, wide);
    }
}

/* Is everything near the box painted? Then no piece within it has to be looked at. */
static bool is_painted(struct paint *b, const double low[2], const double high[2]) {
    double y[2] = {low[1] - b->low[1], high[1] - b->low[1]};
    uint32_t rows[2], range[2];
    rows_of(b, y[0], y[1], rows);
    for (uint32_t row = rows[0]; row <= rows[1]; row++) {
        double wide = half_width(b, y[0], y[1], row);
        double x[2] = {low[0] - b->low[0] - wide, high[0] - b->low[0] + wide};
        if (wide < 0) continue;
        columns_of(b, x, range);
        if (next_unpainted(b, (size_t)row * b->pattern->columns, range[0]) <= range[1])
            return false;
    }
    return true;
}

static int compare_crossings(const void *p, const void *q) {
    const struct crossing *a = p, *b = q;
    if (a->row != b->row) return a->row < b->row ? -1 : 1;
    return (a->x > b->x) - (a->x < b->x);
}

/* Adds where the side pq crosses the middle lines of strips. A line at the height of an end counts
 * with the side above it, so the two sides at a vertex agree. */
static bool add_crossings(struct paint *b, const double p[2], const double q[2], size_t *count,
                          struct err *err) {
    double first = ceil((smaller(p[1], q[1]) - b->low[1]) / b->height - 0.5);
    double end = ceil((larger(p[1], q[1]) - b->low[1]) / b->height - 0.5);
    for (double row = first; row < end; row++) {
        double y = b->low[1] + (row + 0.5) * b->height;
        if (!mem_grow(b->crossing, &b->crossing_cap, *count + 1, err)) return false;
        b->crossing[(*count)++] =
            (struct crossing){p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0]),
                              clamp(row, b->pattern->ny), p[1] < q[1] ? 1 : -1};
    }
    return true;
}

/* Paints the cells whose middles lie between crossings with a winding number other than 0. */
static void fill(struct paint *b, size_t count) {
    const struct crossing *at = b->crossing;
    double unit = b->pattern->kind == PATTERN_HEX ? b->width / 2 : b->width, middle[2];
    int winding = 0;
    centre_of(b, 0, 0, middle);
    if (count > 0) qsort(b->crossing, count, sizeof *b->crossing, compare_crossings);
    for (size_t i = 0; i + 1 < count; i++) {
        double first = ceil((at[i].x - b->low[0] - middle[0]) / unit);
        double last = floor((at[i + 1].x - b->low[0] - middle[0]) / unit);
        winding += at[i].turn; /* 0 after the last of a row */
        if (winding == 0) continue;
        for (uint32_t c = clamp(first, b->pattern->columns); c <= last; c++)
            b->keep[(size_t)at[i].row * b->pattern->columns + c] = 1;
    }
}

bool paint_polygon(struct paint *b, size_t n, const double (*xy)[2], struct err *err) {
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    size_t count = 0;
    for (size_t i = 0; i < n; i++)
        for (int c = 0; c < 2; c++) {
            low[c] = smaller(low[c], xy[i][c]);
            high[c] = larger(high[c], xy[i][c]);
        }
    if (is_painted(b, low, high)) return true;
    for (size_t i = 0; i < n; i++) {
        const double *p = xy[i], *q = xy[i + 1 < n ? i + 1 : 0];
        paint_segment(b, p, q);
        if (!add_crossings(b, p, q, &count, err)) return false;
    }
    fill(b, count);
    return true;
}

/* The n cells around vertex i of row j; NULL beyond the rectangle. */
static int cells_around(const struct paint *b, uint32_t i, uint32_t j, uint8_t *cell[6]) {
    const struct pattern *p = b->pattern;
    int64_t column[6];
    int n = pattern_around(p, i, j, column);
    for (int k = 0; k < n; k++) {
        int64_t row = k < n / 2 ? j : (int64_t)j - 1;
        bool there = column[k] >= 0 && row >= 0 && row < p->ny;
        cell[k] = there ? b->keep + row * p->columns + column[k] : NULL;
    }
    return n;
}

/* Length of the gap that begins at cell k after a kept one, or 0 if none begins there. */
static int gap_at(uint8_t *const cell[6], int n, int k) {
    int length = 0;
    const uint8_t *before = cell[(k + n - 1) % n];
    if (!before || !*before) return 0;
    while (length < n && !(cell[(k + length) % n] && *cell[(k + length) % n])) length++;
    return length;
}

/* Fills the smallest gap if the kept cells around a vertex form several fans; returns the number of
 * cells that this took. */
static size_t join_fans(struct paint *b, uint32_t i, uint32_t j) {
    uint8_t *cell[6];
    int n = cells_around(b, i, j, cell), gaps = 0, best = 0, shortest = n;
    for (int k = 0; k < n; k++) {
        int length = gap_at(cell, n, k);
        gaps += length > 0;
        if (length == 0 || length >= shortest) continue;
        shortest = length;
        best = k;
    }
    if (gaps < 2) return 0;
    for (int k = 0; k < shortest; k++) {
        INVARIANT(cell[(best + k) % n]);
        *cell[(best + k) % n] = 1;
    }
    return (size_t)shortest;
}

size_t paint_join_fans(struct paint *b) {
    size_t added = 0, before;
    do {
        before = added;
        for (uint32_t j = 0; j <= b->pattern->ny; j++)
            for (uint32_t i = 0, n = pattern_row_vertices(b->pattern, j); i < n; i++)
                added += join_fans(b, i, j);
    } while (added > before);
    return added;
}
