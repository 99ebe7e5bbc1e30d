/* SPDX-License-Identifier: GPL-3.0-or-later */
/* script_run - carries out a script on a spline.
 *
 * Each block is resolved first: all its words of POINTS, reaches and targets refer to the spline as
 * it is before the block. Then phi, sigma0 and sigma1, the channels, are edited one after the other
 * by decles_apply, each with its own anchors, slaves and wishes. If one of them is refused, those
 * before it are taken back: a block happens as a whole or not at all.
 *
 * If folds are guarded against (foldfree.h), a block that folds a triangle is taken back too. Or it
 * is limited: taken back and applied once more, to a share of the way, the same for all its anchors
 * and suggestions in all channels. Solutions depend linearly on these, so all control points go
 * that share of their ways; each is rounded once, and what comes of it is certified again. */
#ifndef SCRIPT_RUN_H
#define SCRIPT_RUN_H

#include "decles.h"
#include "foldfree.h"
#include "script.h"
#include "spline.h"

enum script_channel { SCRIPT_PHI, SCRIPT_BOTTOM, SCRIPT_TOP, SCRIPT_CHANNELS };

/* "phi", "bottom", "top" */
extern const char *const script_channel_names[];

/* What an observer is shown; all of it is borrowed for the call. */
struct script_event {
    const struct script *script;
    const struct script_block *block;
    const struct point_set *points; /* of pin, unpin, weight; else the slaves of the edit,
                                       ascending, without anchors and pinned points */

    /* of an edit, after its whole block was applied; else NULL */
    enum script_channel channel;
    const struct decles_edit *edit; /* its anchors are as they were moved, also if limited */
    const double (*from)[2];        /* where the anchors were; z in the first column */
    const struct decles_report *report;
    const struct foldfree_exit *exit; /* NULL unless the block was limited */
};

struct script_observer {
    bool (*see)(void *context, const struct script_event *event, struct err *err);
    void *context;
};

struct script_options {
    struct decles_options decles;
    bool no_fold;  /* refuse blocks that fold; */
    bool limit;    /* or rather limit them, to between 0.99 and 1 times the first exit */
    double margin; /* of foldfree.h */
};

/* Carries out the blocks in order and stops at the first that fails; that one has changed nothing.
 * Errors are placed at the statement or word to blame. ERR_INPUT: points that do not exist, `to`
 * with several points, an anchor twice in a block, a wish for an anchor, raise without depth.
 * ERR_REFUSAL: pinned anchors, and what decles_apply and foldfree refuse. The observer may be NULL.
 * Cost: the first block and the first use of a kind of selector O(points of the grid), everything
 * else in proportion to what is edited. */
bool script_run(const struct script *script, struct spline *spline,
                const struct script_options *options, const struct script_observer *observer,
                struct err *err) WARN_UNUSED;

#endif
