/* SPDX-License-Identifier: GPL-3.0-or-later */
/* history - the comment lines after a grid's first record, "# ...\n" each, as a text. */
#ifndef HISTORY_H
#define HISTORY_H

#include "err.h"

/* A new text: history (NULL: none) and one more line, given without "# " and newline. The caller
 * frees it. NULL: no memory. */
char *history_add(const char *history, const char *line, struct err *err) WARN_UNUSED;

/* Takes the next line from *history: [*text, *end) is what follows "#" and one blank. False at the
 * end. */
bool history_next(const char **history, const char **text, const char **end);

#endif
