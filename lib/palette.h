/* SPDX-License-Identifier: GPL-3.0-or-later */
/* palette - colours, 0xRRGGBBAA, chosen to be told apart also by the colour-blind. */
#ifndef PALETTE_H
#define PALETTE_H

#include <stdint.h>

#define PALETTE_INK    0x222222ffu /* lines and text */
#define PALETTE_PALE   0x9a9a9affu /* what matters less */
#define PALETTE_SHADOW 0xd9d4c7ffu /* models */
#define PALETTE_FOLD   0xe000c8ffu /* where the map folds */

/* Colours for different things, by number; they repeat after 8. */
uint32_t palette_category(uint32_t number);

/* How much area grows: white at 1, blues below, reds above, PALETTE_FOLD where det <= 0. The scale
 * is about logarithmic from 1/4 to 4 and stays as it is beyond. */
uint32_t palette_growth(double det);

/* A scale for values: x in 0..1, dark to light. */
uint32_t palette_value(double x);

#endif
