/* SPDX-License-Identifier: GPL-3.0-or-later */
/* points_io - the syntax of POINTS, the words by which control points are named. */
#ifndef POINTS_IO_H
#define POINTS_IO_H

#include "script.h"
#include "src.h"

#include <stdio.h>

/* Parses [word, word + length), which lies in the current line of src, and appends it to the
 * script. `expected` completes the message about words that look like nothing. Errors are src's. */
bool points_parse(struct src *src, struct script *script, const char *word, size_t length,
                  const char *expected);

/* Does the word have the form of POINTS, right or wrong, rather than of a file name? Words that
 * begin with @ ^ v: v@ v^ box: inside:, the word all, and words of digits and - : , have. */
bool points_is_word(const char *word);

/* Appends a word that stands by itself, not in a script. Errors have no place, but those in the
 * file of inside:FILE. */
bool points_parse_word(struct script *script, const char *word, struct err *err) WARN_UNUSED;

/* Writes " WORD"; `before` and the shortest form of x. */
void points_put(FILE *to, const struct selector *s);
void points_put_numbers(FILE *to, const struct point_set *sorted); /* " 3-9 12" */
void points_put_number(FILE *to, const char *before, double x);

#endif
