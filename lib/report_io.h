/* SPDX-License-Identifier: GPL-3.0-or-later */
/* report_io - findings as lines "key: value", or as the members of a JSON object, in order. */
#ifndef REPORT_IO_H
#define REPORT_IO_H

#include "out.h"

struct report {
    struct out *out;
    bool json;
    bool first; /* nothing in the innermost yet */
};

void report_begin(struct report *r, struct out *out, bool json);
void report_end(struct report *r);

void report_int(struct report *r, const char *key, int64_t n);
void report_number(struct report *r, const char *key, double x); /* infinite: null in JSON */
void report_text(struct report *r, const char *key, const char *text);
/* Numbers on one line, an array in JSON. */
void report_numbers(struct report *r, const char *key, int n, const double *x);

/* A table: in plain text the rows are lines "key: cells"; in JSON an array of arrays. */
void report_table_begin(struct report *r, const char *key);
void report_row(struct report *r, const char *key, int64_t number, const char *text, int n,
                const double *x);
void report_table_end(struct report *r);

#endif
