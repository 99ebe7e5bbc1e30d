/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracle: headers are written here, from the formats' specifications, with sizes that are known,
 * and with as much else around them as the formats allow. They must be read as these sizes, cut at
 * any byte of the header be refused, and with any bytes changed give an error or a size in range.
 * Bytes lie in memory of exactly their number, so that AddressSanitizer sees a reader go too far.
 */
#include "image_header_io.h"

#include "testing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { FILE_MAX = 4096 };

struct file {
    unsigned char byte[FILE_MAX];
    size_t length, header; /* header: bytes without which the size must not be told */
};

static void put(struct file *f, const void *bytes, size_t n) {
    assert_true(f->length + n <= FILE_MAX);
    memcpy(f->byte + f->length, bytes, n);
    f->length += n;
}

static void put_number(struct file *f, uint64_t value, int n, bool big) {
    unsigned char byte[8];
    for (int i = 0; i < n; i++) byte[i] = (unsigned char)(value >> 8 * (big ? n - 1 - i : i));
    put(f, byte, (size_t)n);
}

static void put_random(struct file *f, int64_t n, uint64_t *state) {
    while (n-- > 0) put_number(f, random_bits(state), 1, false);
}

static bool parse(const struct file *f, size_t length, struct image_header *h, struct err *err) {
    unsigned char *exact = malloc(length ? length : 1);
    bool ok;
    *err = (struct err){0};
    memcpy(exact, f->byte, length);
    ok = image_header(h, exact, length, err);
    free(exact);
    return ok;
}

/* --- Writers -------------------------------------------------------------------------------- */

static void chunk(struct file *f, const char *type, const void *data, size_t n) {
    size_t start = f->length + 4;
    put_number(f, n, 4, true);
    put(f, type, 4);
    put(f, data, n);
    put_number(f, crc32(0, f->byte + start, (unsigned)(n + 4)), 4, true);
}

static void write_png(struct file *f, uint32_t w, uint32_t h, uint64_t *state) {
    static const unsigned char kinds[][2] = {{1, 0}, {16, 0}, {8, 2},  {16, 2}, {4, 3},
                                             {8, 3}, {8, 4},  {16, 4}, {8, 6},  {16, 6}};
    struct file ihdr = {.length = 0}, other = {.length = 0};
    const unsigned char *kind = kinds[random_in(state, 0, 9)];
    put_number(&ihdr, w, 4, true);
    put_number(&ihdr, h, 4, true);
    put(&ihdr, kind, 2);
    put_number(&ihdr, 0, 2, true);
    put_number(&ihdr, (uint64_t)random_in(state, 0, 1), 1, true);
    put_random(&other, random_in(state, 0, 50), state);
    put(f, "\x89PNG\r\n\x1a\n", 8);
    chunk(f, "IHDR", ihdr.byte, ihdr.length);
    if (random_in(state, 0, 1)) chunk(f, "tEXt", other.byte, other.length);
    if (random_in(state, 0, 1)) chunk(f, "gAMA", "\0\0\xb1\x8f", 4);
    f->header = f->length + 8;
    chunk(f, "IDAT", other.byte, other.length);
}

/* One entry: a number of n = 2, 4 or 8 bytes in its field of a word. */
static void entry(struct file *f, int tag, int n, uint64_t value, int word, bool big) {
    put_number(f, (uint64_t)tag, 2, big);
    put_number(f, n == 2 ? 3 : n == 4 ? 4 : 16, 2, big);
    put_number(f, 1, word, big);
    put_number(f, value, n, big);
    put_number(f, 0, word - n, big);
}

static void write_tiff(struct file *f, uint32_t w, uint32_t h, uint64_t *state) {
    bool big = random_in(state, 0, 1), wide = random_in(state, 0, 1);
    int word = wide ? 8 : 4, others = (int)random_in(state, 0, 5);
    int64_t gap = random_in(state, 0, 40);
    int bytes = w > UINT16_MAX || h > UINT16_MAX ? 4 : 2;
    if (random_in(state, 0, 1)) bytes = bytes == 2 ? 4 : word;
    put(f, big ? "MM" : "II", 2);
    put_number(f, wide ? 43 : 42, 2, big);
    if (wide) put_number(f, 8, 2, big);
    if (wide) put_number(f, 0, 2, big);
    put_number(f, (uint64_t)((wide ? 16 : 8) + gap), word, big);
    put_random(f, gap, state);
    put_number(f, (uint64_t)others + 3, wide ? 8 : 2, big);
    entry(f, 254, 4, 0, word, big);
    entry(f, 256, bytes, w, word, big);
    entry(f, 257, bytes, h, word, big);
    for (int i = 0; i < others; i++) entry(f, 258 + i, 4, random_bits(state), word, big);
    f->header = f->length;
    put_number(f, 0, word, big);
}

static void attribute(struct file *f, const char *name, const char *type, const void *data,
                      size_t n) {
    put(f, name, strlen(name) + 1);
    put(f, type, strlen(type) + 1);
    put_number(f, n, 4, false);
    put(f, data, n);
}

static void window(struct file *f, const char *name, uint32_t w, uint32_t h, uint64_t *state) {
    int64_t x = random_in(state, -2000, 2000), y = random_in(state, -2000, 2000);
    struct file box = {.length = 0};
    put_number(&box, (uint64_t)x, 4, false);
    put_number(&box, (uint64_t)y, 4, false);
    put_number(&box, (uint64_t)(x + w - 1), 4, false);
    put_number(&box, (uint64_t)(y + h - 1), 4, false);
    attribute(f, name, "box2i", box.byte, box.length);
}

static void write_exr(struct file *f, uint32_t w, uint32_t h, uint64_t *state) {
    put(f, "v/1\x01\x02\0\0\0", 8);
    attribute(f, "compression", "compression", "\3", 1);
    if (random_in(state, 0, 1)) window(f, "displayWindow", w + 7, h + 9, state);
    window(f, "dataWindow", w, h, state);
    if (random_in(state, 0, 1)) window(f, "displayWindow", 5, 5, state);
    attribute(f, "empty", "string", "", 0);
    put(f, "", 1);
    f->header = f->length;
    put_random(f, 20, state);
}

static void write_pnm(struct file *f, uint32_t w, uint32_t h, uint64_t *state) {
    static const char *const gaps[] = {" ", "\n", "\r\n\t ", " # 7 8 9\n", "#\n#12\n  "};
    int kind = (int)random_in(state, 1, 6);
    bool bitmap = kind == 1 || kind == 4;
    char text[256];
    snprintf(text, sizeof text, "P%d%s%u%s%u", kind, gaps[random_in(state, 0, 4)], w,
             gaps[random_in(state, 0, 4)], h);
    put(f, text, strlen(text));
    snprintf(text, sizeof text, "%s%d", gaps[random_in(state, 0, 4)],
             random_in(state, 0, 1) ? 255 : 65535);
    if (!bitmap) put(f, text, strlen(text));
    put(f, "\n", 1);
    f->header = f->length;
    put(f, "1 0 1", 5);
}

static void write_jpeg(struct file *f, uint32_t w, uint32_t h, uint64_t *state) {
    static const unsigned char frames[] = {0xc0, 0xc1, 0xc2, 0xc9, 0xca},
                               others[] = {0xe0, 0xe1, 0xfe, 0xdb, 0xc4, 0xcc};
    put(f, "\xff\xd8", 2);
    for (int64_t n = random_in(state, 0, 4); n >= 0; n--) {
        int64_t length = random_in(state, 0, 60);
        for (int64_t fill = random_in(state, 0, 2); fill >= 0; fill--) put(f, "\xff", 1);
        put_number(f, n ? others[random_in(state, 0, 5)] : frames[random_in(state, 0, 4)], 1, true);
        if (n == 0) break;
        put_number(f, (uint64_t)length + 2, 2, true);
        put_random(f, length, state);
    }
    put_number(f, 11, 2, true);
    put_number(f, 8, 1, true);
    put_number(f, h, 2, true);
    put_number(f, w, 2, true);
    f->header = f->length;
    put(f, "\1\1\x11\0", 4);
}

/* --- Tests ---------------------------------------------------------------------------------- */

static const struct {
    enum image_format format;
    int64_t side_max;
    void (*write)(struct file *, uint32_t w, uint32_t h, uint64_t *state);
} writers[] = {
    {IMAGE_PNG, IMAGE_SIDE_MAX, write_png},     {IMAGE_TIFF, IMAGE_SIDE_MAX, write_tiff},
    {IMAGE_OPENEXR, IMAGE_SIDE_MAX, write_exr}, {IMAGE_PNM, IMAGE_SIDE_MAX, write_pnm},
    {IMAGE_JPEG, UINT16_MAX, write_jpeg},
};

/* A side of any magnitude, 1..max. */
static uint32_t random_side(int64_t max, uint64_t *state) {
    int64_t below = max >> random_in(state, 0, 24);
    return (uint32_t)(below < 1 ? 1 : random_in(state, random_in(state, 0, 9) ? 1 : below, below));
}

static void round_trip(int format, uint64_t seed) {
    uint64_t state = seed;
    uint32_t w = random_side(writers[format].side_max, &state);
    uint32_t h = random_side(writers[format].side_max, &state);
    struct file f = {.length = 0};
    struct image_header header;
    struct err err;
    writers[format].write(&f, w, h, &state);
    check_seed(seed, parse(&f, f.length, &header, &err));
    check_seed(seed, header.format == writers[format].format);
    check_seed(seed, header.width == w && header.height == h);
    check_seed(seed, parse(&f, f.header, &header, &err));
    for (size_t n = 0; n < f.header; n++) {
        check_seed(seed, !parse(&f, n, &header, &err));
        check_seed(seed, err.kind == ERR_INPUT && err.message[0]);
    }
}

static void planted_sizes(void **unused) {
    for (int i = 0; i < test_count(10000); i++) round_trip(i % 5, 0x5eed0000 + (uint64_t)i);
    (void)unused;
}

static void changed_bytes(void **unused) {
    for (int i = 0; i < test_count(50000); i++) {
        uint64_t seed = 0xbad0000 + (uint64_t)i, state = seed;
        struct file f = {.length = 0};
        struct image_header h;
        struct err err;
        writers[i % 5].write(&f, 640, 480, &state);
        for (int64_t n = random_in(&state, 1, 4); n > 0; n--)
            f.byte[random_in(&state, 0, (int64_t)f.header - 1)] =
                (unsigned char)random_bits(&state);
        if (parse(&f, f.length, &h, &err))
            check_seed(seed, h.width >= 1 && h.width <= IMAGE_SIDE_MAX && h.height >= 1 &&
                                 h.height <= IMAGE_SIDE_MAX);
        else
            check_seed(seed, err.kind == ERR_INPUT && err.message[0]);
    }
    (void)unused;
}

/* Bytes as a string literal, without its NUL. */
#define BYTES(literal) literal, sizeof(literal) - 1
#define PNG_BEGIN      "\x89PNG\r\n\x1a\n\0\0\0\xdIHDR"
#define EXR_WINDOW     "v/1\1\2\0\0\0dataWindow\0box2i\0\x10\0\0\0"

static const struct {
    const char *bytes;
    size_t length;
    const char *message;
} bad[] = {
    {BYTES(""), "expected a PNG, TIFF, OpenEXR, PNM or JPEG image, got an empty file"},
    {BYTES("GIF89a\1\0\1\0"), "expected a PNG, TIFF, OpenEXR, PNM or JPEG image, got a file that "
                              "begins with the bytes 47 49 46 38 39 61 01 00"},
    {BYTES("P7\nWIDTH 4\n"), "expected a PNG, TIFF, OpenEXR, PNM or JPEG image, got a file that "
                             "begins with the bytes 50 37 0a 57 49 44 54 48"},
    {BYTES("\x89PNG\r\n\x1a\n"), "bad PNG image: it ends within its header"},
    {BYTES("\x89PNG\r\n\x1a\n\0\0\0\xeIHDR"), "bad PNG image: its first chunk is not IHDR"},
    {BYTES(PNG_BEGIN "\0\0\0\1\0\0\0\1\3\0\0\0\0...."),
     "bad PNG image: IHDR has no such bit depth with its colour type"},
    {BYTES(PNG_BEGIN "\0\0\0\1\0\0\0\1\x8\1\0\0\0...."),
     "bad PNG image: IHDR has no such bit depth with its colour type"},
    {BYTES(PNG_BEGIN "\0\0\0\1\0\0\0\1\x8\2\0\0\2...."),
     "bad PNG image: IHDR has no such compression, filter or interlace method"},
    {BYTES(PNG_BEGIN "\0\0\0\1\0\0\0\1\x8\2\0\0\0...."), "bad PNG image: the CRC of IHDR is wrong"},
    {BYTES("II*\0\x8\0\0\0\0\0"), "expected sides of 1..16777216 pixels, got 0x0"},
    {BYTES("II*\0\xff\xff\xff\xff\0\0"), "bad TIFF image: it ends within its header"},
    {BYTES("II*\0\x8\0\0\0\xff\xff"), "bad TIFF image: it ends within its header"},
    {BYTES("II+\0\x4\0\0\0"), "bad TIFF image: its offsets do not have 8 bytes"},
    {BYTES("II*\0\x8\0\0\0\1\0\0\1\5\0\1\0\0\0\4\0\0\0"),
     "bad TIFF image: width or height is no integer"},
    {BYTES("MM\0*\0\0\0\x8\0\1\1\1\0\3\0\0\0\2\0\4\0\4"),
     "bad TIFF image: width or height is no integer"},
    {BYTES("II*\0\x8\0\0\0\1\0\0\1\x10\0\1\0\0\0\4\0\0\0"),
     "bad TIFF image: width or height is no integer"},
    {BYTES("v/1\1\1\0\0\0\0"), "bad OpenEXR image: its version is not 2"},
    {BYTES("v/1\1\2\0\0\0\0"), "expected sides of 1..16777216 pixels, got 0x0"},
    {BYTES("v/1\1\2\0\0\0a\0b\0\xff\xff\xff\xff\0"),
     "bad OpenEXR image: it ends within its header"},
    {BYTES(EXR_WINDOW "\0\0\0\x80\0\0\0\0\xff\xff\xff\x7f\0\0\0\0\0"),
     "expected sides of 1..16777216 pixels, got 4294967296x1"},
    {BYTES(EXR_WINDOW "\1\0\0\0\0\0\0\0\xff\xff\xff\xff\0\0\0\0\0"),
     "expected sides of 1..16777216 pixels, got -1x1"},
    {BYTES("P4x"), "bad PNM image: expected a blank after P1..P6 and numbers"},
    {BYTES("P5 1 -1 255\n"), "bad PNM image: expected a blank after P1..P6 and numbers"},
    {BYTES("P5 1x1 255\n"), "bad PNM image: expected a blank after P1..P6 and numbers"},
    {BYTES("P5 w h 255\n"), "bad PNM image: expected a blank after P1..P6 and numbers"},
    {BYTES("P4 1 h\n"), "bad PNM image: expected width and height"},
    {BYTES("P5 1 1 0\n"), "bad PNM image: the largest value is not in 1..65535"},
    {BYTES("P5 1 1 65536\n"), "bad PNM image: the largest value is not in 1..65535"},
    {BYTES("P5 1 1 255#\n"), "bad PNM image: expected a blank after the header"},
    {BYTES("P5 1 # 1 255"), "bad PNM image: it ends within its header"},
    {BYTES("P4 0 1\n"), "expected sides of 1..16777216 pixels, got 0x1"},
    {BYTES("P4 1 16777217\n"), "expected sides of 1..16777216 pixels, got 1x16777217"},
    {BYTES("P4 99999999999999999999999999 1\n"),
     "expected sides of 1..16777216 pixels, got 4294967295x1"},
    {BYTES("\xff\xd8\xff\xe0\0\1"), "bad JPEG image: a segment has no length"},
    {BYTES("\xff\xd8\xff\xe0\0\2\0\0"), "bad JPEG image: expected a marker"},
    {BYTES("\xff\xd8\xff\xda\0\2"), "bad JPEG image: it has no frame header before its pixels"},
    {BYTES("\xff\xd8\xff\xd9"), "bad JPEG image: it has no frame header before its pixels"},
    {BYTES("\xff\xd8\xff\xff\xff"), "bad JPEG image: it ends within its header"},
    {BYTES("\xff\xd8\xff\xc0\0\xb\x8\0\0\0\1"), "expected sides of 1..16777216 pixels, got 1x0"},
};

static void messages(void **unused) {
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct file f = {.length = 0};
        struct image_header h;
        struct err err;
        put(&f, bad[i].bytes, bad[i].length);
        assert_false(parse(&f, f.length, &h, &err));
        assert_int_equal(err.kind, ERR_INPUT);
        assert_string_equal(err.message, bad[i].message);
    }
    (void)unused;
}

/* libtiff takes the first of entries with the same tag. */
static void first_entry_counts(void **unused) {
    struct file f = {.length = 0};
    struct image_header h;
    struct err err;
    put(&f, BYTES("II*\0\x8\0\0\0\4\0"));
    entry(&f, 256, 2, 5, 4, false);
    entry(&f, 256, 4, 6, 4, false);
    entry(&f, 257, 4, 7, 4, false);
    entry(&f, 257, 2, 8, 4, false);
    assert_true(parse(&f, f.length, &h, &err));
    assert_int_equal(h.width, 5);
    assert_int_equal(h.height, 7);
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planted_sizes),
        cmocka_unit_test(changed_bytes),
        cmocka_unit_test(messages),
        cmocka_unit_test(first_entry_counts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
