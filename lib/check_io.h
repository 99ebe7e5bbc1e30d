/* SPDX-License-Identifier: GPL-3.0-or-later */
/* check_io - the report of check-grid(1), where its keys are explained. */
#ifndef CHECK_IO_H
#define CHECK_IO_H

#include "check.h"
#include "out.h"

/* Lines "key: value", or JSON; with `all`, triangle by triangle too. */
void check_write(struct out *out, const struct check *c, const struct spline *s, bool json,
                 bool all);

#endif
