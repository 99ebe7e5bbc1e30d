/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Each format has a reader that goes over the bytes with a cursor. Numbers beyond the end are 0 and
 * leave a mark, `cut`, so readers need to look at it only where they repeat something. A reader
 * stores width and height (of PNM also the largest value), and returns what is wrong, or NULL;
 * sizes out of range, also those that were not found and are 0, are refused in one place.
 *
 *   PNG      8 bytes, then chunks { length 4, type 4, data, CRC 4 }; IHDR first, pixels in IDAT
 *   TIFF     header { II|MM, 42, offset of the directory }, directory { n, n entries of 12 bytes }
 *   BigTIFF  the same with 43, 8-byte offsets and counts, entries of 20 bytes
 *   OpenEXR  magic 4, version 4, attributes { name\0 type\0 length 4, data }, \0
 *   PNM      P1..P6, width, height, and but for bitmaps the largest value: decimal, '#' comments
 *   JPEG     FF D8, segments { FF, marker, length 2, data }; the size is in the frame header */
#include "image_header_io.h"

#include "filemap.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <zlib.h>

struct bytes {
    const unsigned char *begin;
    size_t length, at;
    bool big_endian, cut;
};

static void skip(struct bytes *b, uint64_t n) {
    if (n > b->length - b->at) b->cut = true;
    b->at = b->cut ? b->length : b->at + (size_t)n;
}

static uint64_t number(struct bytes *b, int n) {
    const unsigned char *byte = b->begin + b->at;
    uint64_t value = 0;
    skip(b, (uint64_t)n);
    for (int i = 0; i < n && !b->cut; i++) value = value << 8 | byte[b->big_endian ? i : n - 1 - i];
    return value;
}

/* --- PNG ------------------------------------------------------------------------------------ */

#define CHUNK(a, b, c, d) ((uint32_t)(a) << 24 | (b) << 16 | (c) << 8 | (d))

/* Bit depths, as a sum of them, that a colour type may have. */
static unsigned png_depths(uint64_t colour) {
    switch (colour) {
    case 0: /* grey */
        return 1 + 2 + 4 + 8 + 16;
    case 2: /* red, green, blue */
    case 4: /* grey, alpha */
    case 6: /* red, green, blue, alpha */
        return 8 + 16;
    case 3: /* palette */
        return 1 + 2 + 4 + 8;
    default:
        return 0;
    }
}

static const char *png_ihdr(struct bytes *b, int64_t size[3]) {
    const unsigned char *type = b->begin + b->at + 4;
    uint64_t length = number(b, 4), depth, colour, crc;
    if (number(b, 4) != CHUNK('I', 'H', 'D', 'R') || length != 13)
        return "its first chunk is not IHDR";
    for (int c = 0; c < 2; c++) size[c] = (int64_t)number(b, 4);
    depth = number(b, 1);
    colour = number(b, 1);
    if ((depth & (depth - 1)) != 0 || !(depth & png_depths(colour)))
        return "IHDR has no such bit depth with its colour type";
    if (number(b, 2) != 0 || number(b, 1) > 1)
        return "IHDR has no such compression, filter or interlace method";
    crc = number(b, 4);
    return b->cut || crc == crc32(0, type, 4 + 13) ? NULL : "the CRC of IHDR is wrong";
}

static bool letters(uint64_t type) {
    for (int shift = 0; shift < 32; shift += 8) {
        unsigned letter = (unsigned)(type >> shift) & 0xdf; /* upper case */
        if (letter < 'A' || letter > 'Z') return false;
    }
    return true;
}

static const char *read_png(struct bytes *b, int64_t size[3]) {
    const char *wrong;
    b->big_endian = true;
    skip(b, 8);
    wrong = png_ihdr(b, size);
    while (!wrong && !b->cut) {
        uint64_t length = number(b, 4), type = number(b, 4);
        if (type == CHUNK('I', 'D', 'A', 'T')) break;
        if (type == CHUNK('I', 'E', 'N', 'D')) wrong = "it has no pixels (IDAT)";
        if (!letters(type)) wrong = "a chunk's type is not four letters";
        skip(b, length + 4);
    }
    return wrong;
}

/* --- TIFF ----------------------------------------------------------------------------------- */

/* Bytes of the types of integers: BYTE, SHORT, LONG, LONG8. */
static int tiff_bytes(uint64_t type) {
    return type == 1 ? 1 : type == 3 ? 2 : type == 4 ? 4 : type == 16 ? 8 : 0;
}

static const char *read_tiff(struct bytes *b, int64_t size[3]) {
    enum { WIDTH = 256, HEIGHT = 257, BIG = 43 };
    bool big;
    int word;
    uint64_t first;
    b->big_endian = b->begin[0] == 'M';
    skip(b, 2);
    big = number(b, 2) == BIG;
    word = big ? 8 : 4;
    if (big) {
        uint64_t offset = number(b, 2), zero = number(b, 2);
        if (offset != 8 || zero != 0) return "its offsets do not have 8 bytes";
    }
    first = number(b, word);
    b->at = 0;
    skip(b, first);
    for (uint64_t n = number(b, big ? 8 : 2); n > 0 && !b->cut; n--) {
        uint64_t tag = number(b, 2), type = number(b, 2), count = number(b, word);
        int bytes = 0;
        if (tag == WIDTH || tag == HEIGHT) {
            int64_t *side = &size[tag - WIDTH];
            bytes = tiff_bytes(type);
            if (bytes == 0 || bytes > word || count != 1) return "width or height is no integer";
            if (*side == 0)
                *side = (int64_t)number(b, bytes);
            else
                bytes = 0; /* the first of several counts */
        }
        skip(b, (uint64_t)(word - bytes));
    }
    return NULL;
}

/* --- OpenEXR -------------------------------------------------------------------------------- */

/* Goes over a text that a NUL ends; "" if there is no end. */
static const char *text(struct bytes *b) {
    const unsigned char *begin = b->begin + b->at;
    const unsigned char *end = memchr(begin, 0, b->length - b->at);
    skip(b, end ? (uint64_t)(end - begin) + 1 : UINT64_MAX);
    return end ? (const char *)begin : "";
}

static int64_t exr_integer(struct bytes *b) {
    return (int32_t)number(b, 4);
}

static const char *read_exr(struct bytes *b, int64_t size[3]) {
    enum { VERSION = 2 };
    const char *name;
    skip(b, 4);
    if ((number(b, 4) & 0xff) != VERSION) return "its version is not 2";
    while (*(name = text(b))) {
        const char *type = text(b);
        uint64_t length = number(b, 4);
        if (strcmp(name, "dataWindow") == 0 && strcmp(type, "box2i") == 0 && length == 16) {
            for (int c = 0; c < 2; c++) size[c] = -exr_integer(b);
            for (int c = 0; c < 2; c++) size[c] += exr_integer(b) + 1;
        } else
            skip(b, length);
    }
    return NULL;
}

/* --- PNM ------------------------------------------------------------------------------------ */

static int peek(const struct bytes *b) {
    return b->at < b->length ? b->begin[b->at] : -1;
}

static bool blank(int c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/* A decimal number after blanks and comments, or -1. */
static int64_t pnm_number(struct bytes *b) {
    int64_t n = -1;
    while (blank(peek(b)) || peek(b) == '#') {
        if (peek(b) == '#')
            while (!b->cut && peek(b) != '\n') skip(b, 1);
        else
            skip(b, 1);
    }
    if (peek(b) < 0) b->cut = true;
    for (; peek(b) >= '0' && peek(b) <= '9'; skip(b, 1)) {
        n = (n < 0 ? 0 : n) * 10 + (peek(b) - '0');
        if (n > UINT32_MAX) n = UINT32_MAX; /* too large, whatever follows */
    }
    return n;
}

static const char *read_pnm(struct bytes *b, int64_t size[3]) {
    bool bitmap = b->begin[1] == '1' || b->begin[1] == '4';
    int64_t value[3] = {-1, -1, 1};
    skip(b, 2);
    for (int i = 0; i < (bitmap ? 2 : 3); i++) {
        if (!blank(peek(b)) && peek(b) != '#') return "expected a blank after P1..P6 and numbers";
        value[i] = pnm_number(b);
    }
    if (value[0] < 0 || value[1] < 0) return "expected width and height";
    if (value[2] < 1 || value[2] > 65535) return "the largest value is not in 1..65535";
    memcpy(size, value, sizeof value);
    if (!blank(peek(b))) return "expected a blank after the header";
    skip(b, 1);
    return NULL;
}

/* --- JPEG ----------------------------------------------------------------------------------- */

/* Frame headers are C0..CF but for Huffman tables, an extension, and conditioning. */
static bool jpeg_frame(uint64_t marker) {
    return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

static const char *read_jpeg(struct bytes *b, int64_t size[3]) {
    b->big_endian = true;
    skip(b, 2);
    while (!b->cut) {
        uint64_t marker = number(b, 1), length;
        if (marker != 0xff) return "expected a marker";
        while (marker == 0xff) marker = number(b, 1);
        if (marker == 0xda || marker == 0xd9) return "it has no frame header before its pixels";
        length = number(b, 2);
        if (length < 2) return "a segment has no length";
        if (jpeg_frame(marker)) {
            skip(b, 1); /* precision */
            size[1] = (int64_t)number(b, 2);
            size[0] = (int64_t)number(b, 2);
            return NULL;
        }
        skip(b, length - 2);
    }
    return NULL;
}

/* --- All ------------------------------------------------------------------------------------ */

static const struct {
    enum image_format format;
    const char *name;
    size_t length;
    const char *first; /* bytes of the file */
    const char *(*read)(struct bytes *, int64_t size[3]);
} formats[] = {
    {IMAGE_PNG, "PNG", 8, "\x89PNG\r\n\x1a\n", read_png},
    {IMAGE_TIFF, "TIFF", 4, "II*\0", read_tiff},
    {IMAGE_TIFF, "TIFF", 4, "MM\0*", read_tiff},
    {IMAGE_TIFF, "TIFF", 4, "II+\0", read_tiff},
    {IMAGE_TIFF, "TIFF", 4, "MM\0+", read_tiff},
    {IMAGE_OPENEXR, "OpenEXR", 4, "v/1\x01", read_exr},
    {IMAGE_PNM, "PNM", 2, "P1", read_pnm},
    {IMAGE_PNM, "PNM", 2, "P2", read_pnm},
    {IMAGE_PNM, "PNM", 2, "P3", read_pnm},
    {IMAGE_PNM, "PNM", 2, "P4", read_pnm},
    {IMAGE_PNM, "PNM", 2, "P5", read_pnm},
    {IMAGE_PNM, "PNM", 2, "P6", read_pnm},
    {IMAGE_JPEG, "JPEG", 3, "\xff\xd8\xff", read_jpeg},
};

static bool unknown(const unsigned char *byte, size_t length, struct err *err) {
    const char *expected = "expected a PNG, TIFF, OpenEXR, PNM or JPEG image";
    char first[3 * 8 + 1] = "";
    if (length == 0) return err_set(err, ERR_INPUT, "%s, got an empty file", expected);
    for (size_t i = 0; i < 8 && i < length; i++)
        snprintf(first + 3 * i, sizeof first - 3 * i, " %02x", byte[i]);
    return err_set(err, ERR_INPUT, "%s, got a file that begins with the bytes%s", expected, first);
}

static bool begins(const void *bytes, size_t length, const char *first, size_t n) {
    return length >= n && memcmp(bytes, first, n) == 0;
}

bool image_header(struct image_header *h, const void *bytes, size_t length, struct err *err) {
    struct bytes b = {.begin = bytes, .length = length};
    int64_t size[3] = {0, 0, 0};
    const char *wrong;
    size_t i = 0, n = sizeof formats / sizeof *formats;
    while (i < n && !begins(bytes, length, formats[i].first, formats[i].length)) i++;
    if (i == n) return unknown(bytes, length, err);
    wrong = formats[i].read(&b, size);
    if (b.cut) wrong = "it ends within its header";
    if (wrong) return err_set(err, ERR_INPUT, "bad %s image: %s", formats[i].name, wrong);
    for (int c = 0; c < 2; c++)
        if (size[c] < 1 || size[c] > IMAGE_SIDE_MAX)
            return err_set(err, ERR_INPUT,
                           "expected sides of 1..%d pixels, got %" PRId64 "x%" PRId64,
                           IMAGE_SIDE_MAX, size[0], size[1]);
    *h = (struct image_header){.format = formats[i].format,
                               .width = (uint32_t)size[0],
                               .height = (uint32_t)size[1],
                               .largest = (uint32_t)size[2],
                               .pixels = b.at};
    return true;
}

bool image_header_read(struct image_header *h, const char *path, struct err *err) {
    struct filemap f;
    bool ok = filemap_open(&f, path, err);
    if (ok && !image_header(h, f.data, f.length, err)) ok = err_place(err, f.name, 0, 0);
    filemap_close(&f);
    return ok;
}
