/* SPDX-License-Identifier: GPL-3.0-or-later */
/* curves - points of Bezier curves and distances, in plain doubles, for polylines in tests. */
#ifndef CURVES_H
#define CURVES_H

/* By de Casteljau; 1 <= d <= 15. */
void curve_point(int d, const double (*q)[2], double t, double p[2]);

/* Of p from the segment a, b, which may be a point. */
double segment_distance(const double a[2], const double b[2], const double p[2]);

#endif
