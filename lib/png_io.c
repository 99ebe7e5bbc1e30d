/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A chunk is { length 4, type 4, data, CRC 4 }, numbers big endian; a type in lower case is
 * ancillary. */
#include "png_io.h"

#include "mem.h"

#include <stdint.h>
#include <string.h>

enum { SIGNATURE = 8, AROUND = 12 }; /* bytes; the latter of a chunk without its data */

static bool is_pixels(const unsigned char *type) {
    static const char kept[][5] = {"IHDR", "PLTE", "tRNS", "IDAT", "IEND"};
    for (size_t i = 0; i < sizeof kept / sizeof *kept; i++)
        if (memcmp(type, kept[i], 4) == 0) return true;
    return false;
}

/* The length of a chunk as a whole, 0: it goes beyond the end. */
static size_t chunk_length(const unsigned char *chunk, const unsigned char *end) {
    size_t left = (size_t)(end - chunk), n;
    if (left < AROUND) return 0;
    n = (size_t)chunk[0] << 24 | (size_t)chunk[1] << 16 | (size_t)chunk[2] << 8 | chunk[3];
    return n <= left - AROUND ? n + AROUND : 0;
}

/* Appends the chunks at *to; returns what is wrong, or NULL. */
static const char *copy_chunks(unsigned char **to, const unsigned char *chunk,
                               const unsigned char *end) {
    bool begun = false, ended = false; /* the chunks IDAT */
    for (;;) {
        const unsigned char *type = chunk + 4;
        size_t n = chunk_length(chunk, end);
        if (n == 0) return "it ends within a chunk or before IEND";
        if (memcmp(type, "IDAT", 4) != 0)
            ended = begun;
        else if (ended)
            return "other chunks are between those of its pixels (IDAT)";
        else
            begun = true;
        if (is_pixels(type)) {
            memcpy(*to, chunk, n);
            *to += n;
        } else if (type[0] < 'a')
            return "it has an unknown critical chunk";
        if (memcmp(type, "IEND", 4) == 0) return NULL;
        chunk += n;
    }
}

bool png_pixels_only(const void *bytes, size_t length, void **copy, size_t *copy_length,
                     struct err *err) {
    const unsigned char *begin = bytes;
    unsigned char *to = *copy = mem_alloc_unset(length, 1, err);
    const char *wrong;
    if (!to) return false;
    memcpy(to, begin, SIGNATURE);
    to += SIGNATURE;
    wrong = copy_chunks(&to, begin + SIGNATURE, begin + length);
    *copy_length = (size_t)(to - (unsigned char *)*copy);
    if (!wrong) return true;
    free(*copy);
    *copy = NULL;
    return err_set(err, ERR_INPUT, "bad PNG image: %s", wrong);
}
