/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sides - are closed chains of sides the boundary of a domain?
 *
 * They are if they are simple, that is, sides meet only where one ends and the next begins, and
 * what lies left of each is covered exactly once. Decided exactly, for any doubles. */
#ifndef SIDES_H
#define SIDES_H

#include "err.h"
#include "shim_cgal.h"

enum sides_trouble {
    SIDES_SOUND,
    SIDES_SAME_POINT, /* points a < b coincide */
    SIDES_ON_SIDE,    /* point a lies on side b */
    SIDES_CROSS,      /* sides a and b cross */
    SIDES_COVERED,    /* what lies left of side a is covered `times` times, not once */
};

struct sides_fault {
    enum sides_trouble trouble;
    size_t a, b;
    int times;
};

/* Each point ends one side and begins one. False only for want of memory and the like; *fault is
 * the answer. O(n log n). */
bool sides_check(const struct shim_cgal_sides *sides, struct sides_fault *fault,
                 struct err *err) WARN_UNUSED;

/* The fault that a report of shim_cgal is about; false if it is about none. */
bool sides_fault(const struct shim_cgal_sides *sides, const struct shim_cgal_report *report,
                 struct sides_fault *fault, struct err *err) WARN_UNUSED;

/* Says it in words, with the coordinates of these points (those of `sides`, or what they were
 * before they were snapped). */
enum { SIDES_TEXT_MAX = 256 };
void sides_describe(const struct sides_fault *fault, const struct shim_cgal_sides *sides,
                    const double (*point)[2], char text[SIDES_TEXT_MAX]);

#endif
