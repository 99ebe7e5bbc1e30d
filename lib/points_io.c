/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A table of forms says how a word begins and how it has to go on; the first form whose prefix fits
 * decides, and the last one, numbers, fits every word. */
#include "points_io.h"

#include "mem.h"
#include "num.h"
#include "xy_io.h"

#include <string.h>

/* Reads n numbers separated by commas that fill [s, end). */
static bool read_numbers(const char *s, const char *end, int n, double *x) {
    for (int i = 0; i < n; i++) {
        if (i > 0 && (s == end || *s++ != ',')) return false;
        if (num_read(s, end, &x[i], &s) != NUM_OK) return false;
    }
    return s == end;
}

/* Reads a number without sign, below 2^32 - 1; the next character is at *next. */
static bool read_index(const char *s, const char *end, uint32_t *index, const char **next) {
    int64_t n;
    if (s == end || *s < '0' || *s > '9' || num_read_int(s, end, &n, next) != NUM_OK ||
        n >= UINT32_MAX)
        return false;
    *index = (uint32_t)n;
    return true;
}

/* 17, 17-45, t:i,j,k */
static bool parse_number(const char *s, const char *end, struct selector *to) {
    uint32_t first, w;
    if (!read_index(s, end, &first, &s)) return false;
    if (s == end || *s == '-') {
        to->kind = SELECT_RANGE;
        to->range.first = to->range.last = first;
        return s == end ||
               (read_index(s + 1, end, &to->range.last, &s) && s == end && first <= to->range.last);
    }
    to->kind = SELECT_PLACE;
    to->place.triangle = first;
    for (int i = 0; i < 3; i++) {
        if (s == end || *s != ":,,"[i] || !read_index(s + 1, end, &w, &s)) return false;
        to->place.weight[i] = w;
    }
    return s == end;
}

static bool parse_vertex(const char *s, const char *end, struct selector *to) {
    to->kind = SELECT_VERTEX;
    return read_index(s, end, &to->vertex, &s) && s == end;
}

static bool parse_nearest(const char *s, const char *end, struct selector *to) {
    to->kind = SELECT_NEAREST;
    return read_numbers(s, end, 2, to->nearest.xy);
}

static bool parse_box(const char *s, const char *end, struct selector *to) {
    double x[4];
    to->kind = SELECT_BOX;
    if (!read_numbers(s, end, 4, x)) return false;
    for (int c = 0; c < 2; c++) {
        to->box.lo[c] = x[c] < x[c + 2] ? x[c] : x[c + 2];
        to->box.hi[c] = x[c] < x[c + 2] ? x[c + 2] : x[c];
    }
    return true;
}

static bool parse_inside(const char *s, const char *end, struct selector *to) {
    to->kind = SELECT_INSIDE; /* the file is read by need_polygon */
    return s < end && !(end - s == 1 && *s == '-');
}

static bool parse_all(const char *s, const char *end, struct selector *to) {
    to->kind = SELECT_ALL;
    return s == end;
}

static const struct form { /* a word that begins so has to look so */
    const char *prefix, *looks;
    bool (*parse)(const char *s, const char *end, struct selector *to);
    bool nominal, corner;
} forms[] = {
    {"@", "@X,Y", parse_nearest, false, false},
    {"^", "^X,Y", parse_nearest, true, false},
    {"v@", "v@X,Y", parse_nearest, false, true},
    {"v^", "v^X,Y", parse_nearest, true, true},
    {"v:", "v:VERTEX", parse_vertex, false, false},
    {"box:", "box:X0,Y0,X1,Y1", parse_box, false, false},
    {"inside:", "inside:FILE.xy (a file, not stdin)", parse_inside, false, false},
    {"all", "POINTS", parse_all, false, false},
    {"", "POINT, FIRST-LAST or TRIANGLE:I,J,K", parse_number, false, false},
};

static const struct form *form_of(const char *word, size_t length) {
    const struct form *f = forms;
    while (strlen(f->prefix) > length || memcmp(f->prefix, word, strlen(f->prefix)) != 0) f++;
    return f;
}

/* Reads the polygon of inside:FILE, unless it was read before. */
static bool need_polygon(struct src *src, struct script *script, const char *name, size_t length,
                         struct selector *to) {
    const struct script_polygon *found = NULL;
    struct polygon polygon = {0};
    struct err *err = &src->err;
    char *file = strndup(name, length);
    if (!file) return err_memory(err);
    found = script_find_polygon(script, file);
    if (!found && xy_read_polygon(&polygon, file, err))
        found = script_add_polygon(script, file, &polygon, err);
    free(file);
    if (!found) return err_place(err, src->name, src->line, src_column(src, name));
    to->inside.polygon = &found->polygon;
    to->inside.file = found->file;
    return true;
}

/* Parses a word of POINTS; `expected` is for words that begin like none. */
bool points_parse(struct src *src, struct script *script, const char *word, size_t length,
                  const char *expected) {
    const struct form *f = form_of(word, length);
    const char *rest = word + strlen(f->prefix), *end = word + length;
    struct selector s = {.col = src_column(src, word)};
    if (!f->parse(rest, end, &s)) {
        bool stranger = !*f->prefix && (*word < '0' || *word > '9');
        src->at = word;
        return src_expected(src, stranger ? expected : f->looks);
    }
    if (s.kind == SELECT_NEAREST) {
        s.nearest.nominal = f->nominal;
        s.nearest.corner = f->corner;
    }
    if (s.kind == SELECT_INSIDE && !need_polygon(src, script, rest, (size_t)(end - rest), &s))
        return false;
    return script_add_selector(script, &s, &src->err);
}

bool points_is_word(const char *word) {
    size_t length = strlen(word);
    const struct form *f = form_of(word, length);
    if (f->parse == parse_all) return length == strlen(f->prefix);
    if (f->prefix[0]) return true;
    return *word >= '0' && *word <= '9' && strspn(word, "0123456789-:,") == length;
}

bool points_parse_word(struct script *script, const char *word, struct err *err) {
    struct src src;
    const char *got;
    size_t length;
    bool ok;
    src_open_text(&src, "POINTS", word, strlen(word));
    src_line(&src);
    ok = src_word(&src, &got, &length) ? points_parse(&src, script, got, length, "POINTS")
                                       : src_expected(&src, "POINTS");
    ok = ok && src_end_line(&src);
    if (!ok) *err = src.err;
    if (!ok && strcmp(err->file, src.name) == 0) {
        err->file[0] = '\0';
        err->line = err->col = 0;
    }
    src_close(&src);
    return ok;
}

/* ---- writing ---- */

void points_put_number(FILE *to, const char *before, double x) {
    char text[NUM_TEXT_MAX];
    size_t length = num_print(text, x, 0);
    fprintf(to, "%s%.*s", before, (int)length, text);
}

static void put_pair(FILE *to, const char *before, const double x[2], const char *between) {
    points_put_number(to, before, x[0]);
    points_put_number(to, between, x[1]);
}

static void put_nearest(FILE *to, const struct selector *s) {
    fputs(s->nearest.corner ? " v" : " ", to);
    put_pair(to, s->nearest.nominal ? "^" : "@", s->nearest.xy, ",");
}

static void put_range(FILE *to, const struct selector *s) {
    fprintf(to, " %u", s->range.first);
    if (s->range.last != s->range.first) fprintf(to, "-%u", s->range.last);
}

void points_put(FILE *to, const struct selector *s) {
    const int64_t *w = s->place.weight;
    switch (s->kind) {
    case SELECT_ALL:
        fputs(" all", to);
        break;
    case SELECT_RANGE:
        put_range(to, s);
        break;
    case SELECT_PLACE:
        fprintf(to, " %u:%lld,%lld,%lld", s->place.triangle, (long long)w[0], (long long)w[1],
                (long long)w[2]);
        break;
    case SELECT_VERTEX:
        fprintf(to, " v:%u", s->vertex);
        break;
    case SELECT_NEAREST:
        put_nearest(to, s);
        break;
    case SELECT_BOX:
        put_pair(to, " box:", s->box.lo, ",");
        put_pair(to, ",", s->box.hi, ",");
        break;
    case SELECT_INSIDE:
        fprintf(to, " inside:%s", s->inside.file);
        break;
    }
}

void points_put_numbers(FILE *to, const struct point_set *sorted) {
    const uint32_t *p = sorted->point;
    for (size_t i = 0, last; i < sorted->count; i = last + 1) {
        struct selector range = {.kind = SELECT_RANGE};
        for (last = i; last + 1 < sorted->count && p[last + 1] == p[last] + 1;) last++;
        range.range.first = p[i];
        range.range.last = p[last];
        put_range(to, &range);
    }
}
