/* SPDX-License-Identifier: GPL-3.0-or-later */
/* match_options - the options that give two cages the same number of vertices. A tool has
 * MATCH_OPTIONS in its table, hands their keys to match_option, calls match_options_end after the
 * last, and reads the cages with match_options_read. */
#ifndef MATCH_OPTIONS_H
#define MATCH_OPTIONS_H

#include "cli.h"
#include "match.h"

enum { MATCH_KEY = 380, MATCH_MATCH = MATCH_KEY, MATCH_ANCHOR, MATCH_KEY_END };

/* clang-format off */
#define MATCH_OPTIONS                                                                              \
    {MATCH_MATCH, "match", "HOW", "cages of different counts: arclength inserts vertices"},        \
    {MATCH_ANCHOR, "anchor", "I:J", "vertex I goes to vertex J (repeatable; default 0:0)"}
/* clang-format on */

struct match_options { /* zeroed at first */
    bool match;
    struct match_anchor *anchor; /* freed by match_options_free */
    size_t anchor_count, anchor_cap;
};

/* Is this key one of them? */
static inline bool match_option_is(int key) {
    return key >= MATCH_KEY && key < MATCH_KEY_END;
}

/* Takes the current option of cli, whose key this is. */
bool match_option(struct match_options *o, const struct cli *cli, int key,
                  struct err *err) WARN_UNUSED;
bool match_options_end(const struct match_options *o, const struct cli *cli,
                       struct err *err) WARN_UNUSED;
void match_options_free(struct match_options *o);

/* Reads a source and a deformed version of it, matched if that is what the options say. Both are
 * zeroed before, and to be freed in any case. The refusal of different counts names the option. */
bool match_options_read(const struct match_options *o, struct cage *source, const char *source_path,
                        struct cage *target, const char *target_path, struct err *err) WARN_UNUSED;

#endif
