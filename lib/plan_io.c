/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points are written as ranges in ascending order, in the syntax of POINTS. */
#include "plan_io.h"

#include "edits_io.h"
#include "points_io.h"

#include <stdlib.h>

static void put_points(FILE *to, const char *title, const struct point_set *points) {
    if (points->count == 0) return;
    fprintf(to, "  %s", title);
    points_put_numbers(to, points);
    fputc('\n', to);
}

static void put_position(FILE *to, const char *word, const double *at, int columns) {
    fprintf(to, " %s", word);
    for (int c = 0; c < columns; c++) points_put_number(to, " ", at[c]);
}

/* The derived points come in the order of the solver. */
static bool put_derived(FILE *to, const struct decles_report *report, struct err *err) {
    struct point_set derived = {0};
    bool ok = true;
    for (size_t i = 0; ok && i < report->derived; i++)
        ok = point_set_add(&derived, report->derived_point[i], err);
    point_set_sort(&derived);
    put_points(to, "derived", &derived);
    free(derived.point);
    return ok;
}

static bool put_edit(FILE *to, const struct script_event *e, struct err *err) {
    const struct decles_edit *edit = e->edit;
    int columns = e->channel == SCRIPT_PHI ? 2 : 1;
    fprintf(to, "%s: anchors %zu, slaves %zu, derived %zu, conditions %zu\n",
            script_channel_names[e->channel], edit->anchor_count, e->report->slaves,
            e->report->derived, e->report->conditions);
    for (size_t i = 0; i < edit->anchor_count; i++) {
        fprintf(to, "  anchor %u", edit->anchor[i].point);
        put_position(to, "from", e->from[i], columns);
        put_position(to, "to", edit->anchor[i].to, columns);
        fputc('\n', to);
    }
    for (size_t i = 0; i < edit->wish_count; i++) {
        fprintf(to, "  wish %u", edit->wish[i].point);
        put_position(to, "to", edit->wish[i].to, columns);
        fputc('\n', to);
    }
    put_points(to, "slaves", e->points);
    return put_derived(to, e->report, err);
}

bool plan_put_points(FILE *to, const struct script_event *e, struct err *err) {
    if (e->edit) return put_edit(to, e, err);
    put_points(to, "points", e->points);
    return true;
}

bool plan_put_statements(FILE *to, const struct script_event *e, struct err *err) {
    const struct script *script = e->script;
    if (e->block->grouped) fprintf(to, "%s:%zu: begin\n", script->name, e->block->line);
    for (size_t i = 0; i < e->block->count; i++) {
        const struct script_statement *s = &script->statement[e->block->first + i];
        char *text = edits_text(script, s, err);
        if (!text) return false;
        fprintf(to, "%s:%zu: %s\n", script->name, s->line, text);
        free(text);
    }
    if (e->exit) {
        points_put_number(to, "limited to ", e->exit->share);
        fputc('\n', to);
    }
    return true;
}
