/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A glyph is polylines on a raster of unit squares, points written as two digits, column and row,
 * polylines separated by blanks. Rows count from the lowest descender: the baseline is row 2, small
 * letters end in row 6, capitals in row 8. A point by itself is a dot.
 *
 *     8  ------    #####
 *     6  --####    #   #
 *     2  --####    #   #   baseline
 *     0  --#--- */
#include "lettering.h"

#include <string.h>

enum { BASELINE = 2, CAPITAL = 6, GAP = 2, BLANK = 3 };

static const char *const glyphs[128] = {
    ['!'] = "1814 12",
    ['%'] = "0248 0718 3243",
    ['\''] = "1816",
    ['('] = "18060412",
    [')'] = "08161402",
    ['*'] = "2327 0446 0644",
    ['+'] = "0545 2327",
    [','] = "1201",
    ['-'] = "0535",
    ['.'] = "12",
    ['/'] = "0248",
    ['0'] = "120307183847433212",
    ['1'] = "072822 0242",
    ['2'] = "07183847460242",
    ['3'] = "07183847463515 354443321203",
    ['4'] = "32380444",
    ['5'] = "480805354443321203",
    ['6'] = "473818070312324344351504",
    ['7'] = "084812",
    ['8'] = "15060718384746351504031232434435",
    ['9'] = "031232434738180706153546",
    [':'] = "13 15",
    ['<'] = "470543",
    ['='] = "0444 0646",
    ['>'] = "074503",
    ['A'] = "022842 1434",
    ['B'] = "02083847463505 3544433202",
    ['C'] = "4738180703123243",
    ['D'] = "02082846442202",
    ['E'] = "48080242 0535",
    ['F'] = "480802 0535",
    ['G'] = "47381807031232434525",
    ['H'] = "0802 4842 0545",
    ['I'] = "0828 1812 0222",
    ['J'] = "4843321203",
    ['K'] = "0802 480542",
    ['L'] = "080242",
    ['M'] = "0208254842",
    ['N'] = "02084248",
    ['O'] = "120307183847433212",
    ['P'] = "02083847463505",
    ['Q'] = "120307183847433212 2442",
    ['R'] = "02083847463505 2542",
    ['S'] = "473818070615354443321203",
    ['T'] = "0848 2822",
    ['U'] = "080312324348",
    ['V'] = "082248",
    ['W'] = "0812253248",
    ['X'] = "0248 0842",
    ['Y'] = "082548 2522",
    ['Z'] = "08480242",
    ['['] = "28181222",
    [']'] = "08181202",
    ['_'] = "0141",
    ['a'] = "0516263532 341403122233",
    ['b'] = "0802 0516263533221203",
    ['c'] = "3526160503122233",
    ['d'] = "3832 3526160503122233",
    ['e'] = "04343526160503122233",
    ['f'] = "37281712 0626",
    ['g'] = "3631201001 3526160503122233",
    ['h'] = "0802 0516263532",
    ['i'] = "1612 18",
    ['j'] = "161100 18",
    ['k'] = "0802 360432",
    ['l'] = "1812",
    ['m'] = "0206 05162522 25364542",
    ['n'] = "0206 0516263532",
    ['o'] = "160503122233352616",
    ['p'] = "0600 0516263533221203",
    ['q'] = "3630 3526160503122233",
    ['r'] = "0602 051626",
    ['s'] = "35261605142433221203",
    ['t'] = "18132232 0636",
    ['u'] = "0603122233 3632",
    ['v'] = "062246",
    ['w'] = "0612243246",
    ['x'] = "0632 0236",
    ['y'] = "0622 4610",
    ['z'] = "06360232",
    ['{'] = "28171605141322",
    ['|'] = "1811",
    ['}'] = "08171625141302",
};
static const char unknown[] = "0208484202";

static const char *glyph(char c) {
    const char *strokes = (unsigned char)c < 128 ? glyphs[(unsigned char)c] : NULL;
    return strokes ? strokes : unknown;
}

/* In raster units. */
static int advance(char c) {
    int most = 0;
    if (c == ' ') return BLANK;
    for (const char *s = glyph(c); *s; s += *s == ' ' ? 1 : 2)
        if (*s != ' ' && *s - '0' > most) most = *s - '0';
    return most + GAP;
}

double lettering_width(const char *text, double size) {
    int sum = 0;
    for (const char *c = text; *c; c++) sum += advance(*c);
    return (sum > 0 ? sum - GAP : 0) * size / CAPITAL;
}

static void put_glyph(struct drawing *d, double x, double y, double unit, const char *strokes) {
    bool first = true;
    for (const char *s = strokes; *s; s++) {
        double px, py;
        if (*s == ' ') {
            first = true;
            continue;
        }
        px = x + unit * (s[0] - '0');
        py = y - unit * (s[1] - '0' - BASELINE);
        if (first) drawing_move(d, px, py);
        if (!first || !s[2] || s[2] == ' ') drawing_line(d, px, py);
        first = false;
        s++;
    }
}

static void spell(struct drawing *d, double x, double y, double size, enum lettering_align align,
                  const struct drawing_ink *ink, const char *text) {
    const double unit = size / CAPITAL;
    x -= lettering_width(text, size) * (int)align / 2;
    for (const char *c = text; *c; c++) {
        if (*c != ' ') put_glyph(d, x, y, unit, glyph(*c));
        x += unit * advance(*c);
    }
    drawing_paint(d, ink);
}

void lettering(struct drawing *d, double x, double y, double size, enum lettering_align align,
               uint32_t colour, const char *text) {
    spell(d, x, y, size, align, &(struct drawing_ink){.stroke = colour, .width = size / 8}, text);
}

void lettering_halo(struct drawing *d, double x, double y, double size, enum lettering_align align,
                    uint32_t colour, const char *text) {
    const struct drawing_ink ink = {.stroke = colour, .width = size * 0.45};
    spell(d, x, y, size, align, &ink, text);
}
