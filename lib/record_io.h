/* SPDX-License-Identifier: GPL-3.0-or-later */
/* record_io - what the formats grid and bary have in common: a first record with the version, the
 * history behind it, counted records, `end`.
 *
 * As with src.h, errors stick in the reader. Between records, all functions leave the reader at the
 * beginning of the next one. */
#ifndef RECORD_IO_H
#define RECORD_IO_H

#include "out.h"
#include "src.h"

/* Goes to the next record; at the end of the file what is expected next will be missed. */
bool record_next(struct src *src);

/* "NAME 1" and the comment lines after it, each "# ...\n", as *history ("" if there are none; the
 * caller frees it, also on failure). */
bool record_first(struct src *src, const char *name, char **history);

/* "NAME COUNT"; `expected` names all records that could stand here. */
bool record_count(struct src *src, const char *name, const char *expected, int64_t lo, int64_t hi,
                  uint32_t *count);

/* The COUNT of "NAME COUNT" where there is only one right one, which `meaning` explains. */
bool record_exact_count(struct src *src, const char *name, uint32_t count, const char *meaning);

/* "end", and nothing after it. */
bool record_end(struct src *src, const char *expected);

/* Writes "NAME 1" and the history (may be NULL), to which a line `added` (without "# " and newline,
 * or NULL) is appended. */
void record_write_first(struct out *out, const char *name, const char *history, const char *added);

#endif
