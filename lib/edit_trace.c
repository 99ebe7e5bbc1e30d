/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "edit_trace.h"

#include "mem.h"

#include <string.h>

static const struct script_block *find_block(const struct script *script, size_t line) {
    for (size_t b = 0; b < script->block_count; b++) {
        const struct script_block *block = &script->block[b];
        if (block->grouped && block->line == line) return block;
        for (size_t s = block->first; s < block->first + block->count; s++)
            if (script->statement[s].line == line) return block;
    }
    return NULL;
}

static bool add_move(struct edit_trace *trace, const struct edit_move *move, struct err *err) {
    if (!mem_grow(trace->move, &trace->move_cap, trace->move_count + 1, err)) return false;
    trace->move[trace->move_count++] = *move;
    return true;
}

static bool add_anchors(struct edit_trace *trace, const struct script_event *e, struct err *err) {
    for (size_t i = 0; i < e->edit->anchor_count; i++) {
        const struct decles_anchor *anchor = &e->edit->anchor[i];
        struct edit_move move = {.point = anchor->point, .role = EDIT_ANCHOR};
        memcpy(move.from, e->from[i], sizeof move.from);
        memcpy(move.wish, anchor->to, sizeof move.wish);
        memcpy(move.to, anchor->to, sizeof move.to);
        if (!add_move(trace, &move, err)) return false;
    }
    return true;
}

static bool add_derived(struct edit_trace *trace, const struct script_event *e, struct err *err) {
    const struct decles_report *r = e->report;
    for (size_t i = 0; i < r->derived; i++) {
        struct edit_move move = {.point = r->derived_point[i]};
        move.role = point_set_has(e->points, move.point) ? EDIT_SLAVE : EDIT_DERIVED;
        memcpy(move.from, r->before + 2 * i, sizeof move.from);
        memcpy(move.wish, r->suggested + 2 * i, sizeof move.wish);
        if (!add_move(trace, &move, err)) return false;
    }
    return true;
}

static bool see(void *context, const struct script_event *e, struct err *err) {
    struct edit_trace *trace = context;
    size_t count = e->report ? e->report->conditions : 0;
    if (e->block != trace->block || !e->edit || e->channel != SCRIPT_PHI) return true;
    if (!add_anchors(trace, e, err) || !add_derived(trace, e, err) ||
        !mem_grow(trace->condition, &trace->condition_cap, count, err))
        return false;
    if (count > 0) memcpy(trace->condition, e->report->condition, count * sizeof *trace->condition);
    trace->condition_count = count;
    return true;
}

bool edit_trace(struct edit_trace *trace, const struct script *script, size_t line,
                struct spline *spline, const struct decles_options *options, struct err *err) {
    struct script cut = *script;
    struct script_options run = {.decles = *options};
    struct script_observer observer = {see, trace};
    *trace = (struct edit_trace){.block = find_block(script, line)};
    if (!trace->block)
        return err_set_at(err, ERR_INPUT, script->name, line, 0, "expected a statement, got none");
    cut.block_count = (size_t)(trace->block - script->block) + 1;
    if (!script_run(&cut, spline, &run, &observer, err)) return false;
    if (trace->move_count == 0)
        return err_set_at(err, ERR_REFUSAL, script->name, line, 0,
                          "the statement moves no points of phi");
    for (size_t i = 0; i < trace->move_count; i++)
        memcpy(trace->move[i].to, spline->phi[trace->move[i].point], sizeof trace->move[i].to);
    return true;
}

void edit_trace_free(struct edit_trace *trace) {
    free(trace->move);
    free(trace->condition);
    *trace = (struct edit_trace){0};
}
