/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Coordinates: asked for as points, they make a list of as many lines; that list, named by the
 * places that were read, is read again as the same places. */
#include "fuzzing.h"
#include "places_io.h"

static void make_cage(struct cage *c) {
    const double square[5][2] = {{0, 1}, {1, 1}, {1, 0}, {0.5, 0}, {0, 0}}; /* clockwise */
    struct err err = {0};
    INVARIANT(cage_init(c, square, 5, &err));
}

static size_t lines(const char *text, size_t size) {
    size_t n = 0;
    for (size_t i = 0; i < size; i++) n += text[i] == '\n';
    return n;
}

/* Places for the points that are in the text, x y each. */
static struct fuzz_text name(struct fuzz_text points, const struct places *p,
                             const struct cage *c) {
    struct fuzz_file file = fuzz_open(points.bytes, points.size);
    struct filemap f;
    struct fuzz_text text;
    struct err err = {0};
    struct out out;
    INVARIANT(filemap_open(&f, file.path, &err));
    fuzz_out(&out, &text);
    INVARIANT(places_name(&out, &f, p, c, 0, &err) && out_close(&out, &err));
    filemap_close(&f);
    close(file.fd);
    return text;
}

static void expect_same(const struct places *a, const struct places *b) {
    INVARIANT(a->count == b->count);
    for (size_t i = 0; i < a->count; i++) {
        const struct icc_place *x = &a->place[i], *y = &b->place[i];
        INVARIANT(x->side == y->side);
        if (x->side == ICC_OUTSIDE) {
            INVARIANT(memcmp(a->point[i], b->point[i], sizeof a->point[i]) == 0);
            continue;
        }
        INVARIANT(x->t == y->t && x->lambda - y->lambda < 1e-15 && y->lambda - x->lambda < 1e-15);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct fuzz_file file = fuzz_open(data, size), again;
    struct filemap f, g;
    struct places p, q;
    struct fuzz_text points, named;
    struct cage c;
    struct err err = {0};
    struct out out;
    make_cage(&c);
    INVARIANT(filemap_open(&f, file.path, &err));
    if (places_read(&p, &f, &c, &err)) {
        fuzz_out(&out, &points);
        INVARIANT(places_ask(&out, &f, &p, 0, &err) && out_close(&out, &err));
        INVARIANT(lines(points.bytes, points.size) == lines((const char *)data, size));
        named = name(points, &p, &c);
        again = fuzz_open(named.bytes, named.size);
        INVARIANT(filemap_open(&g, again.path, &err) && places_read(&q, &g, &c, &err));
        expect_same(&p, &q);
        places_free(&q);
        filemap_close(&g);
        close(again.fd);
        free(named.bytes);
        free(points.bytes);
        places_free(&p);
    } else {
        INVARIANT(err.kind == ERR_INPUT && err.message[0] && err.line > 0);
    }
    filemap_close(&f);
    close(file.fd);
    cage_free(&c);
    return 0;
}
