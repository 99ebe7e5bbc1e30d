/* SPDX-License-Identifier: GPL-3.0-or-later */
/* result_options - what the programs share whose result is a grid: the options --digits and -o, and
 * writing it, with the command in its history. A tool has RESULT_OPTIONS last in its table and
 * hands their keys to result_option. */
#ifndef RESULT_OPTIONS_H
#define RESULT_OPTIONS_H

#include "cli.h"
#include "grid_io.h"

enum { RESULT_DIGITS = 320 };

/* clang-format off */
#define RESULT_OPTIONS                                                                             \
    {RESULT_DIGITS, "digits", "N", "significant digits, 1..17 (default: shortest exact)"},         \
    {'o', "output", "FILE", "write to FILE instead of stdout"}
/* clang-format on */

struct result_options {
    int64_t digits; /* 0: shortest exact */
    const char *output;
};

/* Takes the current option of cli, whose key this is. */
bool result_option(struct result_options *o, const struct cli *cli, int key,
                   struct err *err) WARN_UNUSED;

/* Writes the grid; the line about this command is added behind file->history. */
bool result_write(const struct result_options *o, const struct cli *cli,
                  const struct grid_file *file, struct err *err) WARN_UNUSED;

#endif
