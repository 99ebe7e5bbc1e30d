/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A block becomes one decles_edit a channel:
 *
 *     statements --resolve--> anchors, motions, wishes, slaves of phi, bottom, top
 *                --check----> no point twice, no wish for an anchor
 *                --tidy-----> slaves ascending, without anchors and pinned points
 *                --apply----> channel by channel
 *                --guard----> does it fold? if it is to be limited: undo, apply a share of it
 *                --tell-----> the observer
 *
 * Nothing is changed before `apply`; from then on, whatever fails, all is taken back: the anchors
 * (their old positions are in `from`) and the derived points (in the report, of which each channel
 * keeps a copy). */
#include "script_run.h"

#include "decles_motion.h"
#include "mem.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const char *const script_channel_names[] = {"phi", "bottom", "top"};

/* Points that a block names as anchors or wishes, to find those named twice. */
struct naming {
    uint32_t point, col;
    bool wish;
    size_t line;
};

/* A report whose lists are copies. */
struct kept_report {
    struct decles_report report;
    uint32_t *derived;
    double *suggested, *before;
    uint64_t *condition;
    size_t derived_cap, suggested_cap, before_cap, condition_cap;
};

struct channel {
    double *q; /* component c of point p: q[2*p + c], c < columns */
    int columns;
    size_t anchor_count, anchor_cap, from_cap, moved_cap;
    struct decles_anchor *anchor; /* as the statements have them */
    struct decles_anchor *moved;  /* as they were moved, by all of that or a share of it */
    double (*from)[2];
    size_t motion_count, motion_cap;
    struct decles_motion *motion;
    size_t wish_count, wish_cap;
    struct decles_wish *wish;
    size_t naming_count, naming_cap;
    struct naming *naming;
    struct point_set slaves, anchored; /* anchored: the anchors, ascending */
    struct decles_edit edit;           /* the last one, and its report */
    struct kept_report kept;
};

struct run {
    const struct script *script;
    struct decles_editor *editor;
    struct foldfree *guard; /* NULL: folds are none of our business */
    bool limit;
    struct select_space space;
    struct point_set points, near; /* of the statement being resolved */
    struct channel channel[SCRIPT_CHANNELS];
    bool has_depth;
};

/* ---- errors ---- */

static bool place_at(const struct run *run, const struct script_statement *s, struct err *err) {
    return err_place(err, run->script->name, s->line, s->col);
}

/* Says of a refused edit which statement, or that the block, it was, and, unless it is the guard
 * who refuses, which channel. */
static bool place_refusal(const struct run *run, const struct script_block *b, const char *channel,
                          struct err *err) {
    const struct script_statement *s = &run->script->statement[b->first];
    struct err inner = *err;
    if (inner.kind == ERR_REFUSAL)
        err_set(err, ERR_REFUSAL, "%s%s%s: %s", b->grouped ? "block" : script_verb_names[s->verb],
                channel ? ", " : "", channel ? channel : "", inner.message);
    return err_place(err, run->script->name, b->line, b->col);
}

/* ---- resolving ---- */

static bool resolve_words(struct run *run, const struct script_statement *s,
                          struct script_words words, struct point_set *set, struct err *err) {
    for (size_t i = words.first; i < words.first + words.count; i++) {
        const struct selector *word = &run->script->selector[i];
        if (!select_points(&run->space, word, set, err))
            return err_place(err, run->script->name, s->line, word->col);
    }
    point_set_sort(set);
    return true;
}

/* The points near the anchors that may follow them: reach, within, with. */
static bool resolve_slaves(struct run *run, const struct script_statement *s, struct err *err) {
    struct point_set *near = &run->near;
    near->count = 0;
    return (!s->has_reach || select_reach(&run->space, &run->points, s->reach, near, err)) &&
           (!s->has_within || select_within(&run->space, &run->points, s->within, near, err)) &&
           resolve_words(run, s, s->with, near, err);
}

static struct decles_motion motion_of(const struct script_statement *s) {
    struct decles_motion m = {.kind = DECLES_TRANSLATE};
    memcpy(m.centre, s->about, sizeof m.centre);
    if (s->verb == SCRIPT_ROTATE) {
        m.kind = DECLES_ROTATE;
        m.degrees = s->by[0];
    } else if (s->verb == SCRIPT_SCALE) {
        m.kind = DECLES_SCALE;
        m.factor = s->by[0];
    } else
        for (int c = 0; c < 2; c++)
            m.by[c] = s->target == SCRIPT_FROM_TO ? s->to[c] - s->from[c] : s->by[c];
    return m;
}

/* A statement's motion, ready to be applied to many points. */
struct mover {
    struct decles_motion motion;
    struct decles_turn turn;
};

static void position(const struct channel *ch, uint32_t p, double at[2]) {
    at[1] = 0;
    for (int c = 0; c < ch->columns; c++) at[c] = ch->q[2 * (size_t)p + (size_t)c];
}

static bool add_naming(struct channel *ch, const struct script_statement *s, uint32_t p,
                       struct err *err) {
    if (!mem_grow(ch->naming, &ch->naming_cap, ch->naming_count + 1, err)) return false;
    ch->naming[ch->naming_count++] = (struct naming){
        .point = p, .wish = s->verb == SCRIPT_SUGGEST, .line = s->line, .col = s->col};
    return true;
}

/* What holds for anchors and wishes alike: not pinned, and a place that is a number. */
static bool check_target(const struct run *run, const struct script_statement *s, uint32_t p,
                         const double to[2], struct err *err) {
    const char *verb = script_verb_names[s->verb];
    if (decles_is_pinned(run->editor, p))
        err_set(err, ERR_REFUSAL, "%s: point %u is pinned", verb, p);
    else if (!isfinite(to[0]) || !isfinite(to[1]))
        err_set(err, ERR_REFUSAL, "%s: the new position of point %u is too large", verb, p);
    else
        return true;
    return place_at(run, s, err);
}

/* Moves point p by the statement: as an anchor, or as a wish. */
static bool add_target(struct run *run, struct channel *ch, const struct script_statement *s,
                       const struct mover *mover, uint32_t p, struct err *err) {
    double from[2], to[2];
    position(ch, p, from);
    decles_move(&mover->motion, 1, mover->turn, from, 2, to);
    if (!check_target(run, s, p, to, err) || !add_naming(ch, s, p, err)) return false;
    if (s->target == SCRIPT_TO) memcpy(to, s->to, sizeof to); /* not rounded once more */
    if (s->verb == SCRIPT_SUGGEST) {
        if (!mem_grow(ch->wish, &ch->wish_cap, ch->wish_count + 1, err)) return false;
        ch->wish[ch->wish_count++] = (struct decles_wish){.point = p, .to = {to[0], to[1]}};
        return true;
    }
    if (!mem_grow(ch->anchor, &ch->anchor_cap, ch->anchor_count + 1, err) ||
        !mem_grow(ch->from, &ch->from_cap, ch->anchor_count + 1, err))
        return false;
    memcpy(ch->from[ch->anchor_count], from, sizeof from);
    ch->anchor[ch->anchor_count++] = (struct decles_anchor){
        .point = p, .motion = (uint32_t)ch->motion_count, .to = {to[0], to[1]}};
    return point_set_add(&ch->anchored, p, err);
}

/* `to` moves its one point by the difference, which is what its slaves are suggested. */
static void set_difference(const struct run *run, const struct channel *ch,
                           const struct script_statement *s, struct decles_motion *m) {
    double from[2];
    position(ch, run->points.point[0], from);
    for (int c = 0; c < ch->columns; c++) m->by[c] = s->to[c] - from[c];
}

static bool resolve_channel(struct run *run, struct channel *ch, const struct script_statement *s,
                            struct err *err) {
    struct mover mover = {.motion = motion_of(s)};
    mover.turn = decles_turn(&mover.motion, 1);
    if (s->target == SCRIPT_TO) set_difference(run, ch, s, &mover.motion);
    for (size_t i = 0; i < run->points.count; i++)
        if (!add_target(run, ch, s, &mover, run->points.point[i], err)) return false;
    for (size_t i = 0; i < run->near.count; i++)
        if (!point_set_add(&ch->slaves, run->near.point[i], err)) return false;
    if (!mem_grow(ch->motion, &ch->motion_cap, ch->motion_count + 1, err)) return false;
    ch->motion[ch->motion_count++] = mover.motion;
    return true;
}

static bool is_edited(const struct script_statement *s, enum script_channel channel) {
    if (s->verb != SCRIPT_RAISE) return channel == SCRIPT_PHI;
    return (channel == SCRIPT_BOTTOM && s->bottom) || (channel == SCRIPT_TOP && s->top);
}

static bool resolve(struct run *run, const struct script_statement *s, struct err *err) {
    run->points.count = 0;
    if (s->verb == SCRIPT_RAISE && !run->has_depth) {
        err_set(err, ERR_INPUT, "raise: expected a grid with depth, got one without");
        return place_at(run, s, err);
    }
    if (!resolve_words(run, s, s->points, &run->points, err)) return false;
    if (s->target == SCRIPT_TO && run->points.count != 1) {
        err_set(err, ERR_INPUT, "%s: expected one point with 'to', got %zu",
                script_verb_names[s->verb], run->points.count);
        return place_at(run, s, err);
    }
    if (!resolve_slaves(run, s, err)) return false;
    for (int c = 0; c < SCRIPT_CHANNELS; c++)
        if (is_edited(s, (enum script_channel)c) && !resolve_channel(run, &run->channel[c], s, err))
            return false;
    return true;
}

/* ---- checking and tidying ---- */

static int compare_namings(const void *a, const void *b) {
    const struct naming *m = a, *n = b;
    if (m->point != n->point) return m->point < n->point ? -1 : 1;
    return (m->line > n->line) - (m->line < n->line);
}

static bool check_namings(const struct run *run, struct channel *ch, struct err *err) {
    if (ch->naming_count < 2) return true;
    qsort(ch->naming, ch->naming_count, sizeof *ch->naming, compare_namings);
    for (size_t i = 1; i < ch->naming_count; i++) {
        const struct naming *first = &ch->naming[i - 1], *again = &ch->naming[i];
        if (first->point != again->point) continue;
        return err_set_at(err, ERR_INPUT, run->script->name, again->line, again->col,
                          "%s point %u, which is %s of line %zu in the same block",
                          again->wish ? "suggest for" : "second anchor at", again->point,
                          first->wish ? "suggested by the statement" : "an anchor", first->line);
    }
    return true;
}

static void tidy_slaves(const struct run *run, struct channel *ch) {
    size_t kept = 0;
    point_set_sort(&ch->anchored);
    point_set_sort(&ch->slaves);
    for (size_t i = 0; i < ch->slaves.count; i++) {
        uint32_t p = ch->slaves.point[i];
        if (!point_set_has(&ch->anchored, p) && !decles_is_pinned(run->editor, p))
            ch->slaves.point[kept++] = p;
    }
    ch->slaves.count = kept;
}

static void clear_channel(struct channel *ch) {
    ch->anchor_count = ch->motion_count = ch->wish_count = ch->naming_count = 0;
    ch->slaves.count = ch->anchored.count = 0;
    ch->kept.report.derived = 0;
}

static bool prepare(struct run *run, const struct script_block *b, struct err *err) {
    for (int c = 0; c < SCRIPT_CHANNELS; c++) clear_channel(&run->channel[c]);
    for (size_t i = 0; i < b->count; i++)
        if (!resolve(run, &run->script->statement[b->first + i], err)) return false;
    for (int c = 0; c < SCRIPT_CHANNELS; c++) {
        struct channel *ch = &run->channel[c];
        if (b->count > 1 && !check_namings(run, ch, err)) return false;
        if (ch->wish_count > 0 && ch->anchor_count == 0)
            return err_set_at(err, ERR_INPUT, run->script->name, ch->naming[0].line,
                              ch->naming[0].col,
                              "suggest: expected a move, rotate or scale in the same block");
        tidy_slaves(run, ch);
    }
    return true;
}

/* ---- applying ---- */

static bool keep_report(struct kept_report *kept, const struct decles_report *r, size_t k,
                        struct err *err) {
    size_t n = r->derived;
    if (!mem_grow(kept->derived, &kept->derived_cap, n, err) ||
        !mem_grow(kept->suggested, &kept->suggested_cap, k * n, err) ||
        !mem_grow(kept->before, &kept->before_cap, k * n, err) ||
        !mem_grow(kept->condition, &kept->condition_cap, r->conditions, err))
        return false;
    for (size_t i = 0; i < n; i++) kept->derived[i] = r->derived_point[i];
    for (size_t i = 0; i < k * n; i++) {
        kept->suggested[i] = r->suggested[i];
        kept->before[i] = r->before[i];
    }
    for (size_t i = 0; i < r->conditions; i++) kept->condition[i] = r->condition[i];
    kept->report = *r;
    kept->report.derived_point = kept->derived;
    kept->report.suggested = kept->suggested;
    kept->report.before = kept->before;
    kept->report.condition = kept->condition;
    return true;
}

/* The index of current positions follows phi. */
static void note_moves(struct run *run, const struct decles_report *report) {
    const struct channel *ch = &run->channel[SCRIPT_PHI];
    for (size_t i = 0; i < ch->anchor_count; i++) select_moved(&run->space, ch->anchor[i].point);
    for (size_t i = 0; i < report->derived; i++)
        select_moved(&run->space, report->derived_point[i]);
}

/* Puts the channel back to where it was before the edit of the report. */
static void undo_channel(struct run *run, struct channel *ch, const struct decles_report *report) {
    size_t k = (size_t)ch->columns;
    for (size_t i = 0; i < report->derived; i++)
        for (size_t c = 0; c < k; c++)
            ch->q[2 * (size_t)report->derived_point[i] + c] = report->before[k * i + c];
    for (size_t i = 0; i < ch->anchor_count; i++)
        for (size_t c = 0; c < k; c++) ch->q[2 * (size_t)ch->anchor[i].point + c] = ch->from[i][c];
    if (ch == &run->channel[SCRIPT_PHI]) note_moves(run, report);
}

/* Harmless for channels that were not edited yet. */
static void undo(struct run *run) {
    for (int c = 0; c < SCRIPT_CHANNELS; c++)
        undo_channel(run, &run->channel[c], &run->channel[c].kept.report);
}

/* The edit of a channel, or a share of it. */
static bool make_edit(struct channel *ch, double share, struct err *err) {
    if (!mem_grow(ch->moved, &ch->moved_cap, ch->anchor_count, err)) return false;
    for (size_t i = 0; i < ch->anchor_count; i++) {
        ch->moved[i] = ch->anchor[i];
        for (int c = 0; share < 1 && c < ch->columns; c++)
            ch->moved[i].to[c] = decles_between(ch->from[i][c], ch->anchor[i].to[c], share);
    }
    ch->edit = (struct decles_edit){ch->anchor_count, ch->slaves.count, ch->motion_count,
                                    ch->wish_count,   ch->moved,        ch->slaves.point,
                                    ch->motion,       ch->wish,         share};
    return true;
}

static bool apply_channel(struct run *run, const struct script_block *b, enum script_channel c,
                          double share, struct err *err) {
    struct channel *ch = &run->channel[c];
    struct decles_report report = {0};
    if (ch->anchor_count == 0) return true;
    if (!make_edit(ch, share, err)) return false;
    if (!decles_apply(run->editor, ch->q, 2, ch->columns, &ch->edit, &report, err))
        return place_refusal(run, b, script_channel_names[c], err);
    if (c == SCRIPT_PHI) note_moves(run, &report);
    if (keep_report(&ch->kept, &report, (size_t)ch->columns, err)) return true;
    undo_channel(run, ch, &report);
    return false;
}

static bool apply(struct run *run, const struct script_block *b, double share, struct err *err) {
    for (int c = 0; c < SCRIPT_CHANNELS; c++)
        if (!apply_channel(run, b, (enum script_channel)c, share, err)) return false;
    return true;
}

/* ---- guarding against folds ---- */

/* Tells the guard what the block has moved, and from where. */
static bool touch(struct run *run, struct err *err) {
    for (int c = 0; c < SCRIPT_CHANNELS; c++) {
        const struct channel *ch = &run->channel[c];
        if (!foldfree_touch(run->guard, ch->anchored.point, ch->anchored.count, err) ||
            !foldfree_touch(run->guard, ch->kept.derived, ch->kept.report.derived, err))
            return false;
    }
    for (int c = 0; c < SCRIPT_CHANNELS; c++) {
        const struct channel *ch = &run->channel[c];
        size_t k = (size_t)ch->columns;
        enum foldfree_component of = FOLDFREE_PHI + (enum foldfree_component)c;
        for (size_t i = 0; i < ch->anchor_count; i++)
            foldfree_was(run->guard, of, ch->anchor[i].point, ch->from[i]);
        for (size_t i = 0; i < ch->kept.report.derived; i++)
            foldfree_was(run->guard, of, ch->kept.derived[i], ch->kept.before + k * i);
    }
    return true;
}

/* Applies the share at which the block is limited. Rounding may spoil that, next to a fold: a
 * little less will do. The exit was found within 2^-9, so the third step back is within 1 %. */
static bool limit(struct run *run, const struct script_block *b, struct foldfree_exit *exit,
                  struct err *err) {
    for (int step = 0;; step++) {
        struct err folds;
        undo(run);
        if (!apply(run, b, exit->share, err) || !touch(run, err)) return false;
        if (foldfree_check(run->guard, &folds)) return true;
        if (step == 3 || folds.kind != ERR_REFUSAL) {
            *err = folds;
            return place_refusal(run, b, NULL, err);
        }
        exit->share -= 0x1p-9 * exit->share;
    }
}

/* Lets the block pass as it was applied, or limits it, or refuses it. */
static bool guard(struct run *run, const struct script_block *b, struct foldfree_exit *exit,
                  struct err *err) {
    foldfree_begin(run->guard);
    if (!touch(run, err)) return false;
    if (!(run->limit ? foldfree_find_exit(run->guard, exit, err) : foldfree_check(run->guard, err)))
        return place_refusal(run, b, NULL, err);
    return exit->share == 1 || limit(run, b, exit, err);
}

/* ---- edits and settings ---- */

static bool tell(const struct run *run, const struct script_block *b,
                 const struct foldfree_exit *exit, const struct script_observer *observer,
                 struct err *err) {
    for (int c = 0; observer && c < SCRIPT_CHANNELS; c++) {
        const struct channel *ch = &run->channel[c];
        struct script_event event = {.script = run->script,
                                     .block = b,
                                     .points = &ch->slaves,
                                     .channel = (enum script_channel)c,
                                     .edit = &ch->edit,
                                     .from = (const double(*)[2])ch->from,
                                     .report = &ch->kept.report,
                                     .exit = exit->share < 1 ? exit : NULL};
        if (ch->anchor_count > 0 && !observer->see(observer->context, &event, err)) return false;
    }
    return true;
}

static bool run_edit(struct run *run, const struct script_block *b,
                     const struct script_observer *observer, struct err *err) {
    struct foldfree_exit exit = {.share = 1};
    if (!prepare(run, b, err)) return false;
    if (apply(run, b, 1, err) && (!run->guard || guard(run, b, &exit, err)) &&
        tell(run, b, &exit, observer, err))
        return true;
    undo(run);
    return false;
}

/* pin, unpin, weight */
static bool run_setting(struct run *run, const struct script_block *b,
                        const struct script_observer *observer, struct err *err) {
    const struct script_statement *s = &run->script->statement[b->first];
    struct script_event event = {.script = run->script, .block = b, .points = &run->points};
    run->points.count = 0;
    if (!resolve_words(run, s, s->points, &run->points, err)) return false;
    for (size_t i = 0; i < run->points.count; i++) {
        uint32_t p = run->points.point[i];
        if (s->verb == SCRIPT_WEIGHT)
            decles_weigh(run->editor, p, s->by[0]);
        else
            decles_pin(run->editor, p, s->verb == SCRIPT_PIN);
    }
    return !observer || observer->see(observer->context, &event, err);
}

static bool run_block(struct run *run, const struct script_block *b,
                      const struct script_observer *observer, struct err *err) {
    enum script_verb verb = run->script->statement[b->first].verb;
    INVARIANT(b->count > 0);
    if (script_moves(verb) || verb == SCRIPT_SUGGEST) return run_edit(run, b, observer, err);
    return run_setting(run, b, observer, err);
}

/* ---- the whole ---- */

static void open_channels(struct run *run, struct spline *spline) {
    run->channel[SCRIPT_PHI].q = &spline->phi[0][0];
    run->channel[SCRIPT_PHI].columns = 2;
    run->has_depth = spline->grid.has_depth;
    for (int c = SCRIPT_BOTTOM; c <= SCRIPT_TOP; c++) {
        run->channel[c].q = run->has_depth ? &spline->sigma[0][c - SCRIPT_BOTTOM] : NULL;
        run->channel[c].columns = 1;
    }
}

static void free_channel(struct channel *ch) {
    free(ch->anchor);
    free(ch->from);
    free(ch->motion);
    free(ch->wish);
    free(ch->naming);
    free(ch->slaves.point);
    free(ch->anchored.point);
    free(ch->moved);
    free(ch->kept.derived);
    free(ch->kept.suggested);
    free(ch->kept.before);
    free(ch->kept.condition);
}

static void close_run(struct run *run) {
    for (int c = 0; c < SCRIPT_CHANNELS; c++) free_channel(&run->channel[c]);
    free(run->points.point);
    free(run->near.point);
    select_free(&run->space);
    decles_free(run->editor);
    foldfree_free(run->guard);
}

static bool open_run(struct run *run, struct spline *spline, const struct script_options *options,
                     struct err *err) {
    run->limit = options->limit;
    run->editor = decles_new(&spline->grid, &options->decles, err);
    if (!run->editor) return false;
    if (options->no_fold && !(run->guard = foldfree_new(spline, options->margin, err)))
        return false;
    open_channels(run, spline);
    select_init(&run->space, &spline->grid, (const double(*)[2])spline->phi);
    return true;
}

bool script_run(const struct script *script, struct spline *spline,
                const struct script_options *options, const struct script_observer *observer,
                struct err *err) {
    struct run run = {.script = script};
    bool ok;
    if (script->block_count == 0) return true;
    ok = open_run(&run, spline, options, err) ||
         err_place(err, script->name, script->block[0].line, script->block[0].col);
    for (size_t i = 0; ok && i < script->block_count; i++)
        ok = run_block(&run, &script->block[i], observer, err);
    close_run(&run);
    return ok;
}
