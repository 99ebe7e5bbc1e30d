/* SPDX-License-Identifier: GPL-3.0-or-later */
/* polylines - lines and points of the plane with labels, as icc-map --show prints them. */
#ifndef POLYLINES_H
#define POLYLINES_H

#include "err.h"

#include <stdint.h>

#define POLYLINES_NO_NAME UINT32_MAX
enum { POLYLINES_NAMES_MAX = 256 };

struct polylines { /* arrays from mem.h */
    size_t line_count, point_count, name_count;
    size_t *start;      /* line l: points start[l] .. start[l+1]; one point: a dot */
    double (*point)[2]; /* world units */
    uint32_t *name_of;  /* of each line: an index of `name`, or POLYLINES_NO_NAME: */
    double *value;      /* its label is this number; 0 without a label */
    char **name;        /* different labels that are no numbers, in order of appearance */
    double range[2];    /* of all values */
};

/* Makes them: lines one after the other, each labelled and then given its points. Zeroed but for p,
 * which is zeroed as well. */
struct polylines_maker {
    struct polylines *p;
    /* private */
    size_t point_cap, start_cap, name_of_cap, value_cap, name_cap;
};

/* Begins a line that is labelled by a number; one of at least one point. */
bool polylines_number(struct polylines_maker *m, double label, struct err *err) WARN_UNUSED;

/* Begins a line that is labelled by a word, no number. Refuses the 257th different one. */
bool polylines_word(struct polylines_maker *m, const char *word, size_t length,
                    struct err *err) WARN_UNUSED;
bool polylines_point(struct polylines_maker *m, const double p[2], struct err *err) WARN_UNUSED;

/* To be called after the last one; there is a line. */
void polylines_end(struct polylines_maker *m);
void polylines_free(struct polylines *p); /* harmless on a zeroed struct */

#endif
