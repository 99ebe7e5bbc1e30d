/* SPDX-License-Identifier: GPL-3.0-or-later */
/* decles_rank - can E be kept, and which of its conditions are redundant? Steps 0, 3 and 4 of
 * decles.md. */
#ifndef DECLES_RANK_H
#define DECLES_RANK_H

#include "decles_sets.h"
#include "exact.h"

/* Step 0: refuses if a condition of E does not hold, naming its edge. */
bool decles_check(const struct decles_sets *sets, const struct c1_field *values,
                  struct err *err) WARN_UNUSED;

/* Which conditions of E are independent in the columns of D. The caller frees `rows`, also on
 * failure. */
bool decles_rows_init(struct exact_rows *rows, const struct decles_sets *sets,
                      struct err *err) WARN_UNUSED;

/* Step 3: lets D grow (by *added points) until A can be anywhere or the positions wanted for A
 * agree; else refuses, naming anchors and conditions. Checks the conditions that come in. Step 4:
 * `rows` tells which conditions are independent in the columns of D; as above. */
bool decles_close(struct decles_sets *sets, const struct decles_edit *edit,
                  const struct c1_field *values, struct exact_rows *rows, size_t *added,
                  struct err *err) WARN_UNUSED;

#endif
