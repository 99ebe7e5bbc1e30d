/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The triangulator knows only one of two sides that meet; the other is found by trying all. */
#include "sides.h"

#include "predicate.h"

#include <stdio.h>

static const double *end_of(const struct shim_cgal_sides *s, size_t side, int which) {
    return s->point[s->side[side][which]];
}

static bool between(double x, double a, double b) {
    return a < b ? a <= x && x <= b : b <= x && x <= a;
}

static bool is_on_side(const struct shim_cgal_sides *s, size_t point, size_t side) {
    const double *a = end_of(s, side, 0), *b = end_of(s, side, 1), *p = s->point[point];
    if (s->side[side][0] == point || s->side[side][1] == point) return false;
    return between(p[0], a[0], b[0]) && between(p[1], a[1], b[1]) && predicate_orient(a, b, p) == 0;
}

/* Each has its ends strictly on both sides of the other. */
static bool do_cross(const struct shim_cgal_sides *s, size_t i, size_t j) {
    const double *a = end_of(s, i, 0), *b = end_of(s, i, 1);
    const double *c = end_of(s, j, 0), *d = end_of(s, j, 1);
    return predicate_orient(a, b, c) * predicate_orient(a, b, d) < 0 &&
           predicate_orient(c, d, a) * predicate_orient(c, d, b) < 0;
}

static struct sides_fault touch(const struct shim_cgal_sides *s, size_t side) {
    size_t j = 0;
    for (size_t p = 0; p < s->point_count; p++)
        if (is_on_side(s, p, side)) return (struct sides_fault){SIDES_ON_SIDE, p, side, 0};
    while (j < s->side_count && !do_cross(s, side, j)) j++;
    INVARIANT(j < s->side_count);
    return (struct sides_fault){SIDES_CROSS, side, j, 0};
}

bool sides_fault(const struct shim_cgal_sides *sides, const struct shim_cgal_report *report,
                 struct sides_fault *fault, struct err *err) {
    switch (report->status) {
    case SHIM_CGAL_OK:
        *fault = (struct sides_fault){SIDES_SOUND, 0, 0, 0};
        return true;
    case SHIM_CGAL_SAME_POINT:
        *fault = (struct sides_fault){SIDES_SAME_POINT, report->at[0], report->at[1], 0};
        return true;
    case SHIM_CGAL_TOUCH:
        *fault = touch(sides, report->at[0]);
        return true;
    case SHIM_CGAL_WINDING:
        *fault = (struct sides_fault){SIDES_COVERED, report->at[0], 0, report->winding};
        return true;
    case SHIM_CGAL_MEMORY:
        return err_memory(err);
    case SHIM_CGAL_FLAT:
        return err_set(err, ERR_REFUSAL, "all points lie on a line");
    default:
        return err_set(err, ERR_REFUSAL, "the triangulation failed: %.500s", report->message);
    }
}

bool sides_check(const struct shim_cgal_sides *sides, struct sides_fault *fault, struct err *err) {
    struct shim_cgal_report report;
    shim_cgal_check(sides, &report);
    return sides_fault(sides, &report, fault, err);
}

static bool have_side(const struct shim_cgal_sides *s, size_t a, size_t b) {
    for (size_t i = 0; i < s->side_count; i++)
        if ((s->side[i][0] == a && s->side[i][1] == b) ||
            (s->side[i][0] == b && s->side[i][1] == a))
            return true;
    return false;
}

struct side_text {
    char text[96];
};

static struct side_text side_text(const struct shim_cgal_sides *s, const double (*point)[2],
                                  size_t side) {
    const double *a = point[s->side[side][0]], *b = point[s->side[side][1]];
    struct side_text t;
    snprintf(t.text, sizeof t.text, "the side from (%.9g, %.9g) to (%.9g, %.9g)", a[0], a[1], b[0],
             b[1]);
    return t;
}

void sides_describe(const struct sides_fault *fault, const struct shim_cgal_sides *sides,
                    const double (*point)[2], char text[SIDES_TEXT_MAX]) {
    const double *p = point[fault->a];
    switch (fault->trouble) {
    case SIDES_SAME_POINT:
        snprintf(text, SIDES_TEXT_MAX,
                 have_side(sides, fault->a, fault->b) ? "a side has no length, at (%.9g, %.9g)"
                                                      : "two points are at (%.9g, %.9g)",
                 p[0], p[1]);
        break;
    case SIDES_ON_SIDE:
        snprintf(text, SIDES_TEXT_MAX, "the point (%.9g, %.9g) lies on %s", p[0], p[1],
                 side_text(sides, point, fault->b).text);
        break;
    case SIDES_CROSS:
        snprintf(text, SIDES_TEXT_MAX, "%s crosses %s", side_text(sides, point, fault->a).text,
                 side_text(sides, point, fault->b).text);
        break;
    case SIDES_COVERED:
        snprintf(text, SIDES_TEXT_MAX, "what lies left of %s is covered %d times",
                 side_text(sides, point, fault->a).text, fault->times);
        break;
    case SIDES_SOUND:
        snprintf(text, SIDES_TEXT_MAX, "sound");
        break;
    }
}
