/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Two triangles have no inner point in common if the line through an edge of one has the other on
 * its right. What they then have in common, if more than vertices of both, ends in a vertex of one
 * that is none of the other's. */
#include "overlap.h"

#include "boxes.h"
#include "embed.h"
#include "mem.h"

static const int32_t *corner(const struct grid *g, uint32_t t, int l) {
    return g->vertex[g->triangle[t][l % 3]];
}

/* Does the line through an edge of s have all of t on its right, or on it? */
static bool is_beside(const struct grid *g, uint32_t s, uint32_t t) {
    for (int l = 0; l < 3; l++) {
        const int32_t *a = corner(g, s, l), *b = corner(g, s, l + 1);
        int left = 0;
        for (int m = 0; m < 3; m++) left += predicate_area2(a, b, corner(g, t, m)) > 0;
        if (left == 0) return true;
    }
    return false;
}

static bool is_corner(const struct grid *g, uint32_t t, uint32_t v) {
    const uint32_t *c = g->triangle[t];
    return c[0] == v || c[1] == v || c[2] == v;
}

/* Does t hold a corner of s that is none of its own? */
static bool holds_corner(const struct grid *g, uint32_t t, uint32_t s) {
    for (int m = 0; m < 3; m++) {
        bool inside = !is_corner(g, t, g->triangle[s][m]);
        for (int l = 0; l < 3 && inside; l++)
            inside = predicate_area2(corner(g, t, l), corner(g, t, l + 1), corner(g, s, m)) >= 0;
        if (inside) return true;
    }
    return false;
}

enum overlap_kind overlap_of_triangles(const struct grid *g, uint32_t s, uint32_t t) {
    if (!is_beside(g, s, t) && !is_beside(g, t, s)) return OVERLAP_AREA;
    return holds_corner(g, s, t) || holds_corner(g, t, s) ? OVERLAP_TOUCH : OVERLAP_NONE;
}

struct search {
    const struct grid *g;
    struct overlap *o;
};

static bool visit(void *context, uint32_t s, uint32_t t) {
    struct search *search = context;
    struct overlap *o = search->o;
    enum overlap_kind kind = overlap_of_triangles(search->g, s, t);
    if (kind > o->kind) {
        o->kind = kind;
        o->triangle[0] = s < t ? s : t;
        o->triangle[1] = s < t ? t : s;
    }
    return o->kind != OVERLAP_AREA;
}

static bool name_triangles(struct overlap *o, const struct grid *g, struct err *err) {
    struct search search = {g, o};
    struct boxes boxes = {0};
    struct box *box;
    bool ok = mem_new(box, g->triangle_count, err);
    for (uint32_t t = 0; ok && t < g->triangle_count; t++) {
        double at[3][2];
        for (int i = 0; i < 3; i++)
            for (int c = 0; c < 2; c++) at[i][c] = corner(g, t, i)[c];
        box[t] = box_of_points(3, (const double(*)[2])at);
    }
    ok = ok && boxes_init(&boxes, box, g->triangle_count, err);
    if (ok) (void)boxes_pairs(&boxes, visit, &search);
    INVARIANT(!ok || o->kind != OVERLAP_NONE);
    boxes_free(&boxes);
    free(box);
    return ok;
}

bool overlap_find(struct overlap *o, const struct grid *g, struct err *err) {
    *o = (struct overlap){.kind = OVERLAP_NONE, .triangle = {GRID_NONE, GRID_NONE}};
    return embed_check_grid(g, o->text, err) && (o->text[0] == '\0' || name_triangles(o, g, err));
}
