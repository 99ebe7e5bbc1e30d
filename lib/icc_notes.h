/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_notes - remarks about deformations of cages, on stderr. */
#ifndef ICC_NOTES_H
#define ICC_NOTES_H

#include "cli.h"
#include "icc_map.h"

/* What the map is made of; `name` is what the user calls source and target. Unless verbose, only
 * what a grid fails where that is no refusal. */
void icc_notes_bound(const struct cli *cli, const struct icc_map *m, const char *const name[2],
                     bool verbose);

/* Method grid: what happened to the points of the last batch. */
void icc_notes_mapped(const struct cli *cli, const struct icc_map *m, const char *const name[2]);

#endif
