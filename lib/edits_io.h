/* SPDX-License-Identifier: GPL-3.0-or-later */
/* edits_io - the syntax of editing scripts, supple-edits(5). Errors read
 * "FILE:LINE:COL: expected X, got Y". */
#ifndef EDITS_IO_H
#define EDITS_IO_H

#include "script.h"

/* Reads a script file; NULL or "-" is stdin. O(text). On failure there is nothing to free. */
bool edits_read(struct script *script, const char *path, struct err *err) WARN_UNUSED;

/* Reads statements from memory, without the first record; `name` stands for the file. */
bool edits_parse(struct script *script, const char *name, const char *text, size_t length,
                 struct err *err) WARN_UNUSED;

/* A statement as text, clauses in canonical order, one line without its end. The caller frees it;
 * NULL: no memory. */
char *edits_text(const struct script *script, const struct script_statement *statement,
                 struct err *err) WARN_UNUSED;

#endif
