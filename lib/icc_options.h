/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_options - the options that say how cages are mapped, and the cages themselves, which are the
 * first operands. A tool has ICC_OPTIONS in its table and hands their keys to icc_option. */
#ifndef ICC_OPTIONS_H
#define ICC_OPTIONS_H

#include "cli.h"
#include "icc_map.h"

enum { ICC_KEY = 340, ICC_METHOD = ICC_KEY, ICC_POINTS, ICC_CELL, ICC_KEY_END };

/* clang-format off */
#define ICC_OPTIONS                                                                                \
    {ICC_METHOD, "method", "WHAT", "ray (default)"},                                               \
    {ICC_POINTS, "points", "N", "points inside each cage (default: 20 a side, 600..20000)"},       \
    {ICC_CELL, "cell", "SIZE", "instead: their distance from each other in the source"}
/* clang-format on */

/* Is this key one of them? */
static inline bool icc_option_is(int key) {
    return key >= ICC_KEY && key < ICC_KEY_END;
}

/* Takes the current option of cli, whose key this is. The rule is zeroed before the first. */
bool icc_option(struct icc_rule *rule, const struct cli *cli, int key, struct err *err) WARN_UNUSED;

/* What no single option can know. */
bool icc_options_end(const struct icc_rule *rule, const struct cli *cli,
                     struct err *err) WARN_UNUSED;

#endif
