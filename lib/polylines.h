/* SPDX-License-Identifier: GPL-3.0-or-later */
/* polylines - lines and points of the plane with labels, as icc-map --show prints them. */
#ifndef POLYLINES_H
#define POLYLINES_H

#include "err.h"

#include <stdint.h>

#define POLYLINES_NO_NAME UINT32_MAX

struct polylines { /* arrays from mem.h */
    size_t line_count, point_count, name_count;
    size_t *start;      /* line l: points start[l] .. start[l+1]; one point: a dot */
    double (*point)[2]; /* world units */
    uint32_t *name_of;  /* of each line: an index of `name`, or POLYLINES_NO_NAME: */
    double *value;      /* its label is this number; 0 without a label */
    char **name;        /* different labels that are no numbers, in order of appearance */
    double range[2];    /* of all values */
};

#endif
