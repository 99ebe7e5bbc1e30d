/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sets of an edit. F, the fixed points, are those of its conditions that do not move. */
#include "c1.h"
#include "figure_panel.h"
#include "palette.h"

#include <string.h>

void figure_role_mark(struct drawing *d, double x, double y, double size, enum edit_role role) {
    static const uint32_t fill[] = {[EDIT_FIXED] = 0xffffffff,
                                    [EDIT_ANCHOR] = 0xd55e00ff,
                                    [EDIT_SLAVE] = 0x009e73ff,
                                    [EDIT_DERIVED] = 0x56b4e9ff};
    static const double diamond[4][2] = {{1.4, 0}, {0, 1.4}, {-1.4, 0}, {0, -1.4}};
    if (role == EDIT_FIXED)
        for (int i = 0; i < 4; i++)
            (i ? drawing_line : drawing_move)(d, x + size * diamond[i][0],
                                              y + size * diamond[i][1]);
    if (role == EDIT_FIXED) drawing_close(d);
    if (role != EDIT_FIXED) drawing_disc(d, x, y, role == EDIT_ANCHOR ? 1.5 * size : size);
    drawing_paint(d,
                  &(struct drawing_ink){.fill = fill[role], .stroke = PALETTE_INK, .width = 0.5});
}

/* The points of E are marked as fixed; those that move are painted over that. */
static void mark_fixed(const struct figure_panel *p, double size) {
    const struct grid *g = &p->content->spline->grid;
    const struct edit_trace *edit = p->content->edit;
    const uint32_t d = (uint32_t)g->degree;
    for (size_t i = 0; i < edit->condition_count; i++) {
        struct c1_condition condition =
            c1_condition(g, (uint32_t)(edit->condition[i] / d), (int)(edit->condition[i] % d));
        for (int k = 0; k < 4; k++) {
            double at[2];
            if (condition.coefficient[k] == 0) continue;
            figure_page(p, p->point[condition.point[k]], at);
            figure_role_mark(p->drawing, at[0], at[1], size, EDIT_FIXED);
        }
    }
}

static void draw_arrows(const struct figure_panel *p, const struct edit_move *move) {
    const struct drawing_ink dashed = {.stroke = PALETTE_PALE, .width = 0.6, .dash = 2};
    const struct drawing_ink wish = {.stroke = PALETTE_PALE, .width = 0.6};
    const struct drawing_ink went = {.stroke = PALETTE_INK, .width = 0.8};
    const struct drawing_ink anchor = {.stroke = 0xd55e00ff, .width = 1.4};
    double from[2], by_wish[2], to[2];
    figure_page(p, move->from, from);
    figure_page(p, move->wish, by_wish);
    figure_page(p, move->to, to);
    if (move->role == EDIT_ANCHOR) {
        drawing_arrow(p->drawing, from, to, 7, &anchor);
        return;
    }
    if (move->wish[0] == move->from[0] && move->wish[1] == move->from[1])
        drawing_arrow(p->drawing, from, to, 4, &went);
    else {
        drawing_arrow(p->drawing, from, by_wish, 4, move->role == EDIT_SLAVE ? &wish : &dashed);
        drawing_arrow(p->drawing, by_wish, to, 4, &went);
    }
}

void figure_sets(const struct figure_panel *p) {
    const struct edit_trace *edit = p->content->edit;
    const double size = figure_size(p, 0.14, 1, 3);
    mark_fixed(p, 0.8 * size);
    for (size_t i = 0; p->deformed && i < edit->move_count; i++) draw_arrows(p, &edit->move[i]);
    for (size_t i = edit->move_count; i-- > 0;) { /* anchors last */
        double at[2];
        figure_page(p, p->point[edit->move[i].point], at);
        figure_role_mark(p->drawing, at[0], at[1], size, edit->move[i].role);
    }
}
