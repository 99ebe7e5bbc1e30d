/* SPDX-License-Identifier: GPL-3.0-or-later */
/* edit_trace - what one block of a script does to phi: the sets A, S, D and E, and where points
 * were (p), were suggested to go (p') and went (p''), [14] 5. */
#ifndef EDIT_TRACE_H
#define EDIT_TRACE_H

#include "script_run.h"

enum edit_role { EDIT_FIXED, EDIT_ANCHOR, EDIT_SLAVE, EDIT_DERIVED };

struct edit_move {
    uint32_t point;
    enum edit_role role;            /* a slave is derived too */
    double from[2], wish[2], to[2]; /* of an anchor: wish = to */
};

struct edit_trace { /* arrays from mem.h */
    size_t move_count, condition_count;
    struct edit_move *move;
    uint64_t *condition; /* E, as numbers e*d + m */
    /* private */
    size_t move_cap, condition_cap;
    const struct script_block *block;
};

/* Carries out the script up to the block that has this line, and traces that one. ERR_INPUT: no
 * statement there; ERR_REFUSAL: it does not move points of phi, or is refused. */
bool edit_trace(struct edit_trace *trace, const struct script *script, size_t line,
                struct spline *spline, const struct decles_options *options,
                struct err *err) WARN_UNUSED;
void edit_trace_free(struct edit_trace *trace);

#endif
