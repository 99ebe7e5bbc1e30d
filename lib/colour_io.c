/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "colour_io.h"

#include <string.h>

static const struct {
    const char *name;
    uint32_t colour;
} names[] = {
    {"black", 0x000000ff},  {"white", 0xffffffff}, {"grey", 0x808080ff},    {"gray", 0x808080ff},
    {"red", 0xff0000ff},    {"green", 0x008000ff}, {"blue", 0x0000ffff},    {"yellow", 0xffff00ff},
    {"orange", 0xffa500ff}, {"cyan", 0x00ffffff},  {"magenta", 0xff00ffff}, {"brown", 0xa52a2aff},
    {"none", 0x00000000},
};

static int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

bool colour_read(const char *word, size_t length, uint32_t *colour) {
    uint32_t value = 0;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strlen(names[i].name) == length && memcmp(names[i].name, word, length) == 0) {
            *colour = names[i].colour;
            return true;
        }
    if (length > 0 && *word == '#') {
        word++;
        length--;
    }
    if (length != 6 && length != 8) return false;
    for (size_t i = 0; i < length; i++) {
        int digit = hex_digit(word[i]);
        if (digit < 0) return false;
        value = value << 4 | (uint32_t)digit;
    }
    *colour = length == 8 ? value : value << 8 | 0xff;
    return true;
}

size_t colour_read_list(const char *word, size_t most, uint32_t *colour) {
    for (size_t count = 0; count < most; word++) {
        size_t length = strcspn(word, ",");
        if (!colour_read(word, length, &colour[count++])) return 0;
        word += length;
        if (!*word) return count;
    }
    return 0;
}

bool colour_read_pair(const char *word, uint32_t colour[2]) {
    return colour_read_list(word, 2, colour) == 2;
}
