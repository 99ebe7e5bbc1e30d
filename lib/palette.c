/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The categories are those of Okabe and Ito (2008), the scale of growth is ColorBrewer's RdBu, that
 * of values runs through viridis' hues. */
#include "palette.h"

struct stop {
    double at;
    uint32_t colour;
};

static uint32_t between(const struct stop *a, const struct stop *b, double x) {
    double part = (x - a->at) / (b->at - a->at);
    uint32_t colour = 0xff;
    for (int shift = 8; shift < 32; shift += 8) {
        double from = a->colour >> shift & 255, to = b->colour >> shift & 255;
        colour |= (uint32_t)(from + part * (to - from) + 0.5) << shift;
    }
    return colour;
}

static uint32_t interpolate(int n, const struct stop *stop, double x) {
    if (!(x > stop[0].at)) return stop[0].colour;
    for (int i = 1; i < n; i++)
        if (x < stop[i].at) return between(&stop[i - 1], &stop[i], x);
    return stop[n - 1].colour;
}

uint32_t palette_category(uint32_t number) {
    static const uint32_t colour[8] = {0x0072b2ff, 0xd55e00ff, 0x009e73ff, 0xcc79a7ff,
                                       0xe69f00ff, 0x56b4e9ff, 0x7a5195ff, 0x222222ff};
    return colour[number % 8];
}

uint32_t palette_growth(double det) {
    static const struct stop stop[] = {{0, 0x053061ff},   {0.25, 0x2166acff}, {0.5, 0x67a9cfff},
                                       {0.8, 0xd1e5f0ff}, {1, 0xf7f7f7ff},    {1.25, 0xfddbc7ff},
                                       {2, 0xef8a62ff},   {4, 0xb2182bff},    {16, 0x67001fff}};
    if (!(det > 0)) return PALETTE_FOLD;
    return interpolate(sizeof stop / sizeof *stop, stop, det);
}

uint32_t palette_value(double x) {
    static const struct stop stop[] = {{0, 0x440154ff},
                                       {0.25, 0x3b528bff},
                                       {0.5, 0x21918cff},
                                       {0.75, 0x5ec962ff},
                                       {1, 0xfde725ff}};
    return interpolate(sizeof stop / sizeof *stop, stop, x);
}
