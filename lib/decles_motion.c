/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "decles_motion.h"

#include "dd.h"
#include "trig.h"

struct decles_turn decles_turn(const struct decles_motion *motion, double theta) {
    struct decles_turn turn = {1, 0};
    if (motion->kind == DECLES_ROTATE) trig_degrees(theta * motion->degrees, &turn.c, &turn.s);
    if (motion->kind == DECLES_SCALE) turn.c = trig_pow(motion->factor, theta);
    return turn;
}

/* centre + a x + b y, rounded once. */
static double turned(double centre, double a, struct dd x, double b, struct dd y) {
    struct dd sum = dd_add(dd_mul_double(x, a), dd_mul_double(y, b));
    return dd_add_double(sum, centre).hi;
}

void decles_move(const struct decles_motion *motion, double theta, struct decles_turn turn,
                 const double *q, int k, double to[2]) {
    if (motion->kind == DECLES_TRANSLATE) {
        for (int c = 0; c < k; c++) {
            double by = motion->by[c]; /* whole shares may be of any size */
            to[c] = theta == 1 ? q[c] + by : dd_add_double(dd_two_prod(theta, by), q[c]).hi;
        }
    } else {
        struct dd x = dd_two_sum(q[0], -motion->centre[0]);
        struct dd y = dd_two_sum(q[1], -motion->centre[1]);
        INVARIANT(k == 2);
        to[0] = turned(motion->centre[0], turn.c, x, -turn.s, y);
        to[1] = turned(motion->centre[1], turn.s, x, turn.c, y);
    }
}

double decles_between(double from, double to, double share) {
    struct dd way = dd_two_sum(to, -from);
    return dd_add_double(dd_mul_double(way, share), from).hi;
}
