/* SPDX-License-Identifier: GPL-3.0-or-later */
/* script - an editing script as data: what supple-edits(5) writes, without its syntax.
 *
 * A script is a list of blocks that are carried out in order, each seeing the result of those
 * before. A block is what stands between begin and end, or a statement by itself; it is one edit,
 * all or nothing. Numbers are kept as they were written: whether points exist is known only when
 * the script meets a grid (script_run.h). */
#ifndef SCRIPT_H
#define SCRIPT_H

#include "select.h"

enum script_verb {
    SCRIPT_MOVE,
    SCRIPT_ROTATE,
    SCRIPT_SCALE,
    SCRIPT_RAISE,
    SCRIPT_SUGGEST,
    SCRIPT_PIN,
    SCRIPT_UNPIN,
    SCRIPT_WEIGHT,
};

/* "move", "rotate", ... by verb; NULL ends the table. */
extern const char *const script_verb_names[];

enum script_target { SCRIPT_BY, SCRIPT_TO, SCRIPT_FROM_TO };

struct script_words { /* selector[first .. first+count) of the script */
    size_t first, count;
};

struct script_statement {
    enum script_verb verb;
    enum script_target target; /* rotate, scale: SCRIPT_BY */
    size_t line;
    uint32_t col;
    bool bottom, top; /* raise */
    bool has_reach, has_within;
    uint32_t reach;
    double within;
    struct script_words points, with;
    double by[2]; /* displacement; rotate: degrees; scale: factor; raise, weight: one number */
    double from[2], to[2], about[2];
};

struct script_block {
    size_t first, count; /* statements */
    bool grouped;        /* begin .. end, at `line`; else one statement */
    size_t line;
    uint32_t col;
};

struct script_polygon { /* of inside:FILE; each file is read once */
    struct polygon polygon;
    struct script_polygon *next;
    char file[];
};

struct script {
    char *name; /* of the file, for messages */
    size_t selector_count, statement_count, block_count;
    struct selector *selector;
    struct script_statement *statement;
    struct script_block *block;
    struct script_polygon *polygons;
    size_t selector_cap, statement_cap, block_cap; /* private */
};

bool script_init(struct script *script, const char *name, struct err *err) WARN_UNUSED;
void script_free(struct script *script); /* harmless on a zeroed struct */

bool script_add_selector(struct script *script, const struct selector *selector,
                         struct err *err) WARN_UNUSED;

/* Appends a statement as a block of its own, or to the last block, which is grouped. */
bool script_add_statement(struct script *script, const struct script_statement *statement,
                          bool to_last_block, struct err *err) WARN_UNUSED;

/* Appends a grouped block, as yet empty. */
bool script_add_block(struct script *script, size_t line, uint32_t col,
                      struct err *err) WARN_UNUSED;

/* The polygon of this file if it was added before, else NULL. */
const struct script_polygon *script_find_polygon(const struct script *script, const char *file);

/* Adds a built polygon, which moves into the script (also on failure); NULL: no memory. */
const struct script_polygon *script_add_polygon(struct script *script, const char *file,
                                                struct polygon *polygon,
                                                struct err *err) WARN_UNUSED;

/* Does the verb move points and so begin an edit? (suggest only accompanies one) */
static inline bool script_moves(enum script_verb verb) {
    return verb <= SCRIPT_RAISE;
}

#endif
