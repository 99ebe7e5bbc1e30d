/* SPDX-License-Identifier: GPL-3.0-or-later */
/* decles_drop - which condition of a relation is dropped. */
#ifndef DECLES_DROP_H
#define DECLES_DROP_H

#include "decles_sets.h"
#include "exact.h"

/* Exchanges dependent for independent rows where that keeps the dropped condition nearer to 0 after
 * rounding. tied[i]: relation i has y.A_p != 0 for some point p outside D (updated). The
 * relations stay a basis. Cost: O(relations), and more only where rows are exchanged. */
bool decles_drop(struct exact_rows *rows, const struct decles_sets *sets,
                 const struct decles_values *values, bool *tied, struct err *err) WARN_UNUSED;

#endif
