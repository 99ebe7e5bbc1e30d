/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plan_io - what an edit does, as text for people and awk (decles-edit -n):
 *
 *     bend.edits:3: move @2,1 by 0.2 0.1 reach 3
 *     limited to 0.65625                             (if it was)
 *     phi: anchors 1, slaves 36, derived 122, conditions 63
 *       anchor 7 from 2 1 to 2.2 1.1
 *       wish 95 to 3 4
 *       slaves 41-43 49-51
 *       derived 30 37-38 41-43
 */
#ifndef PLAN_IO_H
#define PLAN_IO_H

#include "script_run.h"

#include <stdio.h>

/* The statements of the event's block, each with its place, and whether it was limited. */
bool plan_put_statements(FILE *to, const struct script_event *e, struct err *err) WARN_UNUSED;

/* What the event says of one channel, or the points of pin, unpin, weight. */
bool plan_put_points(FILE *to, const struct script_event *e, struct err *err) WARN_UNUSED;

#endif
