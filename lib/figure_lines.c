/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Squares lie below, then paths and dots as they come, then what is written. */
#include "figure_panel.h"
#include "lettering.h"
#include "num.h"
#include "palette.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double LETTERS = 8, LETTERS_LEAST = 3; /* height */
enum { LABEL_DIGITS = 4, LABEL_MAX = 64 };

uint32_t figure_word_colour(const struct figure_panel *p, uint32_t name) {
    const struct figure_lines_style *style = &p->options->lines;
    return name < style->colour_count ? style->colour[name] : palette_category(name);
}

static uint32_t colour_of_line(const struct figure_panel *p, size_t l) {
    const struct polylines *lines = p->content->lines;
    double low = lines->range[0], high = lines->range[1];
    if (lines->name_of[l] != POLYLINES_NO_NAME) return figure_word_colour(p, lines->name_of[l]);
    return high > low ? palette_value((lines->value[l] - low) / (high - low)) : PALETTE_INK;
}

static size_t points_of(const struct polylines *lines, size_t l) {
    return lines->start[l + 1] - lines->start[l];
}

/* With a hair of stroke, so that no gap is seen between neighbours. */
static void draw_square(const struct figure_panel *p, size_t l) {
    const struct polylines *lines = p->content->lines;
    const uint32_t colour = colour_of_line(p, l);
    const double r = p->options->lines.square * p->scale / 2;
    double at[2];
    figure_page(p, lines->point[lines->start[l]], at);
    drawing_polygon(p->drawing, 4,
                    (const double[][2]){{at[0] - r, at[1] - r},
                                        {at[0] + r, at[1] - r},
                                        {at[0] + r, at[1] + r},
                                        {at[0] - r, at[1] + r}});
    drawing_paint(p->drawing,
                  &(struct drawing_ink){.fill = colour, .stroke = colour, .width = 0.8});
}

static void draw_line(const struct figure_panel *p, size_t l) {
    const struct polylines *lines = p->content->lines;
    size_t first = lines->start[l], n = points_of(lines, l);
    struct drawing_ink ink = {.stroke = colour_of_line(p, l), .width = p->options->lines.width};
    double at[2];
    for (size_t i = 0; i < n; i++) {
        figure_page(p, lines->point[first + i], at);
        if (n > 1) (i ? drawing_line : drawing_move)(p->drawing, at[0], at[1]);
    }
    if (n == 1) {
        drawing_disc(p->drawing, at[0], at[1], p->options->lines.dot);
        ink = (struct drawing_ink){.fill = ink.stroke};
    }
    drawing_paint(p->drawing, &ink);
}

static void label_text(const struct polylines *lines, size_t l, char text[LABEL_MAX]) {
    if (lines->name_of[l] != POLYLINES_NO_NAME)
        (void)snprintf(text, LABEL_MAX, "%s", lines->name[lines->name_of[l]]);
    else
        text[num_print(text, lines->value[l], LABEL_DIGITS)] = 0;
}

static bool is_dark(uint32_t colour) {
    return 0.3 * (colour >> 24) + 0.6 * (colour >> 16 & 255) + 0.1 * (colour >> 8 & 255) < 135;
}

/* In the middle of a square, as large as there is room for, or beside the dot. */
static void write_label(const struct figure_panel *p, size_t l) {
    const struct polylines *lines = p->content->lines;
    const struct figure_lines_style *style = &p->options->lines;
    const double side = style->square * p->scale;
    double at[2], size = LETTERS;
    char text[LABEL_MAX];
    figure_page(p, lines->point[lines->start[l]], at);
    label_text(lines, l, text);
    if (style->square > 0) {
        size = fmin(fmin(size, 0.5 * side), size * 0.85 * side / lettering_width(text, size));
        if (size >= LETTERS_LEAST)
            lettering(p->drawing, at[0], at[1] + size / 2, size, LETTERING_CENTRE,
                      is_dark(colour_of_line(p, l)) ? 0xffffffff : PALETTE_INK, text);
    } else
        lettering(p->drawing, at[0] + style->dot + 2, at[1] - style->dot - 2, size, LETTERING_LEFT,
                  PALETTE_INK, text);
}

void figure_lines(const struct figure_panel *p) {
    const struct polylines *lines = p->content->lines;
    const bool squares = p->options->lines.square > 0;
    for (size_t l = 0; squares && l < lines->line_count; l++)
        if (points_of(lines, l) == 1) draw_square(p, l);
    for (size_t l = 0; l < lines->line_count; l++)
        if (!squares || points_of(lines, l) > 1) draw_line(p, l);
    for (size_t l = 0; p->options->lines.labels && l < lines->line_count; l++)
        if (points_of(lines, l) == 1) write_label(p, l);
}
