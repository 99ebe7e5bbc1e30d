/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Vertices have slots: vertex i of row j is slot j*stride + i, and the centre of crossed square i
 * of strip j is slot (ny+1)*stride + j*stride + i. A grid gets the used slots in this order.
 *
 * A strip of hex between its even row a and its odd row b; the even row may be below or above:
 *
 *      b0--b1------b2------b3--b4        column  0    a0 b1 b0
 *      | 0/ \  2  / \  4  / \ 6|                 2i   ai b(i+1) bi
 *      | / 1 \   / 3 \   / 5 \ |                 2i+1 ai a(i+1) b(i+1)
 *      a0------a1------a2------a3
 */
#include "pattern.h"

#include "mem.h"

const char *const pattern_names[] = {"diagonal", "cross", "hex", NULL};

static size_t stride(const struct pattern *p) {
    return (size_t)p->nx + 2;
}

static bool is_shifted(const struct pattern *p, uint32_t row) {
    return p->kind == PATTERN_HEX && row % 2 == 1;
}

/* Fills n + 1 lines; consecutive ones must be `least` apart. */
static bool make_lines(int32_t *line, uint32_t n, int32_t low, int32_t high, int least,
                       struct err *err) {
    int64_t width = (int64_t)high - low;
    for (uint32_t i = 0; i <= n; i++)
        line[i] = (int32_t)(low + (2 * width * i + n) / (2 * (int64_t)n));
    for (uint32_t i = 0; i < n; i++)
        if (line[i + 1] - line[i] < least)
            return err_set(err, ERR_REFUSAL,
                           "lattice too coarse: %u cells would share %lld lattice steps", n,
                           (long long)width);
    return true;
}

bool pattern_init(struct pattern *p, enum pattern_kind kind, const uint32_t cells[2],
                  const int32_t low[2], const int32_t high[2], struct err *err) {
    uint64_t columns = kind == PATTERN_HEX ? 2 * (uint64_t)cells[0] + 1 : cells[0];
    int least_x = kind == PATTERN_DIAGONAL ? 1 : 2, least_y = kind == PATTERN_CROSS ? 2 : 1;
    *p = (struct pattern){.kind = kind, .nx = cells[0], .ny = cells[1]};
    INVARIANT(cells[0] > 0 && cells[1] > 0 && low[0] <= high[0] && low[1] <= high[1]);
    if (columns > PATTERN_CELLS_MAX / cells[1])
        return err_set(err, ERR_REFUSAL, "%u x %u cells are more than %d", cells[0], cells[1],
                       PATTERN_CELLS_MAX);
    p->columns = (uint32_t)columns;
    if (mem_new(p->x, (size_t)p->nx + 1, err) && mem_new(p->y, (size_t)p->ny + 1, err) &&
        make_lines(p->x, p->nx, low[0], high[0], least_x, err) &&
        make_lines(p->y, p->ny, low[1], high[1], least_y, err))
        return true;
    pattern_free(p);
    return false;
}

void pattern_free(struct pattern *p) {
    free(p->x);
    free(p->y);
    *p = (struct pattern){0};
}

uint32_t pattern_row_vertices(const struct pattern *p, uint32_t row) {
    return p->nx + (is_shifted(p, row) ? 2 : 1);
}

static int32_t middle(int32_t a, int32_t b) {
    return a + (b - a) / 2;
}

static size_t slot_of(const struct pattern *p, uint32_t i, uint32_t j) {
    return j * stride(p) + i;
}

static size_t centre_of(const struct pattern *p, uint32_t i, uint32_t j) {
    return (p->ny + 1 + j) * stride(p) + i;
}

static void coordinates(const struct pattern *p, size_t slot, int32_t xy[2]) {
    uint32_t i = (uint32_t)(slot % stride(p)), j = (uint32_t)(slot / stride(p));
    if (j > p->ny) {
        j -= p->ny + 1;
        xy[0] = middle(p->x[i], p->x[i + 1]);
        xy[1] = middle(p->y[j], p->y[j + 1]);
        return;
    }
    xy[1] = p->y[j];
    if (!is_shifted(p, j))
        xy[0] = p->x[i];
    else if (i == 0 || i > p->nx)
        xy[0] = p->x[i == 0 ? 0 : p->nx];
    else
        xy[0] = middle(p->x[i - 1], p->x[i]);
}

/* The slots of a cell's corners. */
static int corner_slots(const struct pattern *p, uint32_t column, uint32_t row, size_t slot[4]) {
    uint32_t i = column, even = row % 2 == 0 ? row : row + 1, odd = row % 2 == 0 ? row + 1 : row;
    if (p->kind != PATTERN_HEX) {
        slot[0] = slot_of(p, i, row);
        slot[1] = slot_of(p, i + 1, row);
        slot[2] = slot_of(p, i + 1, row + 1);
        slot[3] = slot_of(p, i, row + 1);
        return 4;
    }
    i = column / 2;
    slot[0] = slot_of(p, i, even);
    slot[1] = column % 2 ? slot_of(p, i + 1, even) : slot_of(p, i + 1, odd);
    slot[2] = column % 2 ? slot_of(p, i + 1, odd) : slot_of(p, i, odd);
    if (even > odd) { /* the drawing upside down */
        size_t swap = slot[1];
        slot[1] = slot[2];
        slot[2] = swap;
    }
    return 3;
}

int pattern_cell(const struct pattern *p, uint32_t column, uint32_t row, int32_t corner[4][2]) {
    size_t slot[4];
    int n = corner_slots(p, column, row, slot);
    for (int c = 0; c < n; c++) coordinates(p, slot[c], corner[c]);
    return n;
}

int pattern_around(const struct pattern *p, uint32_t i, uint32_t j, int64_t column[6]) {
    int half = p->kind == PATTERN_HEX ? 3 : 2;
    int64_t right = p->kind != PATTERN_HEX ? i
                    : is_shifted(p, j)     ? 2 * (int64_t)i
                                           : 2 * (int64_t)i + 1;
    for (int k = 0; k < half; k++) {
        int64_t c = right - k;
        column[k] = column[2 * half - 1 - k] = c >= 0 && c < p->columns ? c : -1;
    }
    return 2 * half;
}

/* The slots of a cell's triangles; returns their number. */
static int cell_triangles(const struct pattern *p, uint32_t column, uint32_t row,
                          size_t triangle[4][3]) {
    size_t s[4], centre = centre_of(p, column, row);
    int n = corner_slots(p, column, row, s);
    if (p->kind == PATTERN_CROSS) {
        for (int c = 0; c < 4; c++) {
            triangle[c][0] = s[c];
            triangle[c][1] = s[(c + 1) % 4];
            triangle[c][2] = centre;
        }
        return 4;
    }
    for (int t = 0; t < n - 2; t++) {
        triangle[t][0] = s[0];
        triangle[t][1] = s[t + 1];
        triangle[t][2] = s[t + 2];
    }
    return n - 2;
}

/* Calls visit with the slots of every triangle of the kept cells. */
static void each_triangle(const struct pattern *p, const uint8_t *keep,
                          void (*visit)(void *context, const size_t slot[3]), void *context) {
    for (uint32_t row = 0; row < p->ny; row++)
        for (uint32_t column = 0; column < p->columns; column++) {
            size_t triangle[4][3];
            if (keep && !keep[(size_t)row * p->columns + column]) continue;
            for (int t = 0, n = cell_triangles(p, column, row, triangle); t < n; t++)
                visit(context, triangle[t]);
        }
}

struct emission {
    struct grid *g;
    uint32_t *number; /* of a slot: first 1 where it is used, then its vertex */
    uint64_t triangles;
};

static void mark_slots(void *context, const size_t slot[3]) {
    struct emission *e = context;
    for (int l = 0; l < 3; l++) e->number[slot[l]] = 1;
    e->triangles++;
}

static void emit_triangle(void *context, const size_t slot[3]) {
    struct emission *e = context;
    for (int l = 0; l < 3; l++) e->g->triangle[e->g->triangle_count][l] = e->number[slot[l]];
    e->g->triangle_count++;
}

static bool emit(const struct pattern *p, const uint8_t *keep, struct emission *e,
                 struct err *err) {
    size_t slots = (2 * (size_t)p->ny + 1) * stride(p);
    uint32_t used = 0;
    each_triangle(p, keep, mark_slots, e);
    for (size_t s = 0; s < slots; s++) used += e->number[s];
    if (!mem_new(e->g->vertex, used, err) || !mem_new(e->g->triangle, e->triangles, err))
        return false;
    for (size_t s = 0; s < slots; s++) {
        if (!e->number[s]) continue;
        coordinates(p, s, e->g->vertex[e->g->vertex_count]);
        e->number[s] = e->g->vertex_count++;
    }
    each_triangle(p, keep, emit_triangle, e);
    return true;
}

bool pattern_triangulate(const struct pattern *p, const uint8_t *keep, struct grid *g,
                         struct err *err) {
    struct emission e = {.g = g};
    bool ok;
    g->vertex_count = g->triangle_count = 0;
    g->vertex = NULL;
    g->triangle = NULL;
    ok = mem_new(e.number, (2 * (size_t)p->ny + 1) * stride(p), err) && emit(p, keep, &e, err);
    free(e.number);
    if (!ok) grid_free(g);
    return ok;
}
