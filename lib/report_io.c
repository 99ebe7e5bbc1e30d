/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keys and texts are ASCII without characters that JSON would want escaped, but for quotes. */
#include "report_io.h"

#include <math.h>

static void separate(struct report *r) {
    if (r->json) out_text(r->out, r->first ? "\n" : ",\n");
    r->first = false;
}

static void put_key(struct report *r, const char *key) {
    separate(r);
    if (r->json)
        out_format(r->out, "\"%s\": ", key);
    else
        out_format(r->out, "%s: ", key);
}

static void line_end(struct report *r) {
    if (!r->json) out_char(r->out, '\n');
}

static void put_number(struct report *r, double x) {
    if (isfinite(x))
        out_double(r->out, x, 0);
    else
        out_text(r->out, r->json ? "null" : isnan(x) ? "nan" : x > 0 ? "inf" : "-inf");
}

static void put_text(struct report *r, const char *text) {
    if (!r->json) {
        out_text(r->out, text);
        return;
    }
    out_char(r->out, '"');
    for (; *text; text++) {
        if (*text == '"' || *text == '\\') out_char(r->out, '\\');
        out_char(r->out, *text);
    }
    out_char(r->out, '"');
}

void report_begin(struct report *r, struct out *out, bool json) {
    *r = (struct report){.out = out, .json = json, .first = true};
    if (json) out_char(out, '{');
}

void report_end(struct report *r) {
    if (r->json) out_text(r->out, "\n}\n");
}

void report_int(struct report *r, const char *key, int64_t n) {
    put_key(r, key);
    out_int(r->out, n);
    line_end(r);
}

void report_number(struct report *r, const char *key, double x) {
    put_key(r, key);
    put_number(r, x);
    line_end(r);
}

void report_text(struct report *r, const char *key, const char *text) {
    put_key(r, key);
    put_text(r, text);
    line_end(r);
}

static void put_cells(struct report *r, int n, const double *x, bool more) {
    for (int i = 0; i < n; i++) {
        if (more || i > 0) out_text(r->out, r->json ? ", " : " ");
        put_number(r, x[i]);
    }
}

void report_numbers(struct report *r, const char *key, int n, const double *x) {
    put_key(r, key);
    if (r->json) out_char(r->out, '[');
    put_cells(r, n, x, false);
    if (r->json) out_char(r->out, ']');
    line_end(r);
}

void report_table_begin(struct report *r, const char *key) {
    if (!r->json) return;
    put_key(r, key);
    out_char(r->out, '[');
    r->first = true;
}

void report_row(struct report *r, const char *key, int64_t number, const char *text, int n,
                const double *x) {
    separate(r);
    if (r->json)
        out_char(r->out, '[');
    else
        out_format(r->out, "%s: ", key);
    out_int(r->out, number);
    out_text(r->out, r->json ? ", " : " ");
    put_text(r, text);
    put_cells(r, n, x, true);
    if (r->json) out_char(r->out, ']');
    line_end(r);
}

void report_table_end(struct report *r) {
    if (!r->json) return;
    out_text(r->out, "\n]");
    r->first = false;
}
