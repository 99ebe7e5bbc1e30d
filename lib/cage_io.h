/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cage_io - cages as .xy files of one loop. */
#ifndef CAGE_IO_H
#define CAGE_IO_H

#include "cage.h"

/* Reads and prepares a cage; NULL or "-" is stdin. All that xy_read_polygon and cage_init refuse,
 * and holes, with the file's name. Freed by cage_free on success. */
bool cage_read(struct cage *c, const char *path, struct err *err) WARN_UNUSED;

/* The same for the deformed version of a cage; messages name both files. What is said where the
 * counts differ ends with `advice`. */
bool cage_read_like(struct cage *c, const char *path, const struct cage *source,
                    const char *source_path, const char *advice, struct err *err) WARN_UNUSED;

#endif
