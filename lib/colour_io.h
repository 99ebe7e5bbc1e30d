/* SPDX-License-Identifier: GPL-3.0-or-later */
/* colour_io - colours as words: RRGGBB or RRGGBBAA in hexadecimal digits, with or without a '#'
 * before them, or one of a few names. */
#ifndef COLOUR_IO_H
#define COLOUR_IO_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What the word may be, for messages. */
#define COLOUR_SYNTAX                                                                              \
    "RRGGBB, RRGGBBAA, black, white, grey, red, green, blue, yellow, orange, cyan, magenta, "      \
    "brown or none"

/* Reads a word as 0xRRGGBBAA. */
bool colour_read(const char *word, size_t length, uint32_t *colour);

/* Up to `most` of them with commas between; returns how many, 0 if the word is something else. */
size_t colour_read_list(const char *word, size_t most, uint32_t *colour);

/* Two of them. */
bool colour_read_pair(const char *word, uint32_t colour[2]);

#endif
