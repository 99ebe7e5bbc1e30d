/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Entries flow from left to right, and on to the next line where they do not fit. */
#include "c1.h"
#include "figure_panel.h"
#include "lettering.h"
#include "num.h"
#include "palette.h"

#include <stdio.h>
#include <string.h>

static const double LEFT = 14, LINE = 18, SIZE = 8.5, MARK = 3.5, GAP = 16;

struct flow {
    struct drawing *d;
    double x, y, width;
    bool used;
};

/* Room for a mark of this width and its text; returns the mark's x. */
static double reserve(struct flow *f, double mark, const char *text) {
    double need = mark + 6 + lettering_width(text, SIZE), x;
    if (f->used && f->x + need > f->width - LEFT) {
        f->x = LEFT;
        f->y += LINE;
    }
    x = f->x;
    f->used = true;
    lettering(f->d, x + mark + 6, f->y + SIZE / 2, SIZE, LETTERING_LEFT, PALETTE_INK, text);
    f->x += need + GAP;
    return x;
}

static void types(struct flow *f, const struct grid *g) {
    bool seen[TYPE_INTERIOR + 1] = {false};
    for (uint32_t p = 0; p < g->point_count; p++) seen[c1_type(g, p)] = true;
    for (int t = 0; t <= TYPE_INTERIOR; t++) {
        double x;
        if (!seen[t]) continue;
        x = reserve(f, 2 * MARK, c1_type_names[t]);
        figure_type_mark(f->d, x + MARK, f->y, MARK, (enum point_type)t);
    }
}

static void roles(struct flow *f) {
    static const struct {
        enum edit_role role;
        const char *text;
    } entry[] = {{EDIT_ANCHOR, "anchor (A)"},
                 {EDIT_SLAVE, "slave (S)"},
                 {EDIT_DERIVED, "derived by type (D)"},
                 {EDIT_FIXED, "fixed (F)"}};
    for (size_t i = 0; i < sizeof entry / sizeof *entry; i++) {
        double x = reserve(f, 2 * MARK, entry[i].text);
        figure_role_mark(f->d, x + MARK, f->y, 0.7 * MARK, entry[i].role);
    }
}

static void arrows(struct flow *f) {
    static const struct drawing_ink wish = {.stroke = PALETTE_PALE, .width = 0.6};
    static const struct drawing_ink went = {.stroke = PALETTE_INK, .width = 0.8};
    double x = reserve(f, 20, "p to p', as suggested");
    drawing_arrow(f->d, (double[]){x, f->y}, (double[]){x + 20, f->y}, 4, &wish);
    x = reserve(f, 20, "p' to p'', as solved");
    drawing_arrow(f->d, (double[]){x, f->y}, (double[]){x + 20, f->y}, 4, &went);
}

static void quads(struct flow *f, bool edit) {
    const struct drawing_ink ink = {.fill = 0xf0e44280, .stroke = 0xb8a800ff, .width = 0.5};
    double x = reserve(f, 14, edit ? "conditions (E)" : "quadrilateral conditions");
    drawing_polygon(
        f->d, 4,
        (const double[][2]){{x, f->y}, {x + 7, f->y - 5}, {x + 14, f->y}, {x + 7, f->y + 5}});
    drawing_paint(f->d, &ink);
}

/* A bar of colours with numbers below some places; its title beside it, or below if there is no
 * room. */
static void scale(struct flow *f, const char *title, int n, const uint32_t *colour, int marks,
                  const int *place, const double *value) {
    const double cell = 7, height = 9;
    const bool beside = LEFT + n * cell + 6 + lettering_width(title, SIZE) <= f->width - LEFT;
    double x = reserve(f, n * cell, beside ? title : "");
    for (int i = 0; i < n; i++) {
        drawing_polygon(f->d, 4,
                        (const double[][2]){{x + i * cell, f->y - height / 2},
                                            {x + (i + 1) * cell, f->y - height / 2},
                                            {x + (i + 1) * cell, f->y + height / 2},
                                            {x + i * cell, f->y + height / 2}});
        drawing_paint(f->d,
                      &(struct drawing_ink){.fill = colour[i], .stroke = colour[i], .width = 0.3});
    }
    for (int i = 0; i < marks; i++) {
        char text[NUM_TEXT_MAX + 1] = "";
        num_print(text, value[i], 3);
        lettering(f->d, x + place[i] * cell, f->y + height / 2 + 10, 6.5, LETTERING_CENTRE,
                  PALETTE_INK, text);
    }
    f->y += 12;
    if (beside) return;
    f->x = LEFT;
    f->y += LINE;
    (void)reserve(f, -6, title);
}

static void growth(struct flow *f) {
    static const double det[] = {0.25, 0.5, 1, 2, 4};
    static const int place[] = {1, 6, 11, 16, 21};
    uint32_t colour[23];
    double d = 0.25;
    colour[0] = PALETTE_FOLD;
    for (int i = 1; i < 23; i++, d *= 1.1486983549970351)
        colour[i] = palette_growth(d); /* 2^(1/5) */
    scale(f, "det grad phi (left: folded)", 23, colour, 5, place, det);
}

/* Has the first line of that name more than a point? */
static bool is_path(const struct polylines *p, uint32_t name) {
    size_t l = 0;
    while (p->name_of[l] != name) l++;
    return p->start[l + 1] - p->start[l] > 1;
}

static void word(struct flow *f, const struct figure_panel *panel, uint32_t i) {
    const struct polylines *p = panel->content->lines;
    const uint32_t colour = figure_word_colour(panel, i);
    struct drawing_ink ink = {.stroke = colour, .width = 1.5};
    if (is_path(p, i)) {
        double x = reserve(f, 14, p->name[i]);
        drawing_move(f->d, x, f->y);
        drawing_line(f->d, x + 14, f->y);
    } else {
        drawing_disc(f->d, reserve(f, 2 * MARK, p->name[i]) + MARK, f->y, 0.8 * MARK);
        ink = (struct drawing_ink){.fill = colour};
    }
    drawing_paint(f->d, &ink);
}

static void lines(struct flow *f, const struct figure_panel *panel) {
    const struct polylines *p = panel->content->lines;
    for (size_t i = 0; i < p->name_count; i++) word(f, panel, (uint32_t)i);
    if (p->range[1] > p->range[0]) {
        uint32_t colour[20];
        for (int i = 0; i < 20; i++) colour[i] = palette_value((i + 0.5) / 20);
        scale(f, "value", 20, colour, 2, (int[]){0, 20}, p->range);
    }
}

double figure_legend(const struct figure_panel *p, double y) {
    struct flow f = {.d = p->drawing, .x = LEFT, .y = y + LINE / 2, .width = p->options->width};
    const struct figure_content *content = p->content;
    const bool sets = content->edit && figure_shows(p, FIGURE_SETS);
    if (content->spline && figure_shows(p, FIGURE_TYPES)) types(&f, &content->spline->grid);
    if (sets) roles(&f);
    if (sets && p->deformed) arrows(&f);
    if (content->spline && figure_shows(p, FIGURE_QUADS)) quads(&f, content->edit != NULL);
    if (content->spline && figure_shows(p, FIGURE_JACOBIAN)) growth(&f);
    if (content->lines) lines(&f, p);
    return f.used ? f.y + LINE : y;
}
