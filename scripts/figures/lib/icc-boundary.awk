# SPDX-License-Identifier: GPL-3.0-or-later
# The configurations at the boundary: what the 8 neighbours of an inside vertex v of the cousin tree can be
# when they are not all inside. Prints one representative of each class under the 8 symmetries of the square as
# polylines, 3 x 3 squares in a frame, labelled by the depth less that of v; and the numbers on standard
# error.
#
#      3 2 1     c[k]: depth of neighbour k less v's, or OUT. Along an edge (k even) depths differ by 1.
#      4 v 0     In a region without holes whose vertices are joined by edges, not by diagonals, a full
#      5 6 7     square has depths d, d + 1, d + 2, d + 1 around it, and a vertex has one higher neighbour,
#                or two that span a full square with it.

BEGIN {
    OUT = 9
    for (n = 0; n < 4 ^ 4 * 3 ^ 4; n++) {
        m = n
        for (k = 0; k < 8; k++) { # -1, 1, OUT along edges; -2, 0, 2, OUT at corners
            q = k % 2 ? 4 : 3
            c[k] = m % q == q - 1 ? OUT : 2 * (m % q) - q + 2
            m = int(m / q)
        }
        if (!possible()) continue
        configurations++
        for (k = pattern = 0; k < 8; k++) pattern = 2 * pattern + (c[k] != OUT)
        patterns += !(pattern in seen)
        seen[pattern]
        if (critical()) bad++
        if (canonical() == code(0, 1)) draw()
    }
    printf "configurations %d\npatterns %d\nclasses %d\ncritical %d\n", configurations, patterns, classes, bad >"/dev/stderr"
}

function at(k) { return c[(k + 16) % 8] }
function is_in(k) { return at(k) != OUT }
function square(k) { return is_in(k) && is_in(k + 1) && is_in(k + 2) } # with v, k even

function possible(    k, inside, along, higher) {
    for (k = 0; k < 8; k++) {
        inside += is_in(k)
        if (is_in(k) && is_in(k + 1) && at(k) - at(k + 1) != 1 && at(k + 1) - at(k) != 1) return 0
    }
    for (k = 0; k < 8; k += 2) {
        along += is_in(k)
        higher += at(k) == -1
        if (is_in(k + 1) && !is_in(k) && !is_in(k + 2)) return 0 # joined by a diagonal only
        # of the two diagonals of a full square one has equal depths, the other d and d + 2
        if (square(k) && (at(k + 1) == 0) == (at(k) == at(k + 2))) return 0
        if (at(k) == -1 && at(k + 4) == -1) return 0
        if (at(k) == -1 && at(k + 2) == -1 && !square(k)) return 0
        if (is_in(k) && !neighbour(k)) return 0
    }
    return inside < 8 && along && (higher == 1 || higher == 2)
}

# As far as can be seen here, the same holds of the neighbours: of k, the higher ones are among its corners and v.
function neighbour(k,    after, before) {
    after = is_in(k + 1) && at(k + 1) == at(k) - 1
    before = is_in(k - 1) && at(k - 1) == at(k) - 1
    if (after && before) return 0
    if (at(k) != 1) return 1
    return (!after || square(k)) && (!before || square(k - 2))
}

# Around v the neighbours in the triangulation that are higher must be one run, and the lower ones another. What is
# outside is lower. Of equal depths, at the corners 1 and 5, either may be higher.
function critical(    tie, k, n, up, corner) {
    split("0 1 2 4 5 6", corner, " ")
    for (tie = 0; tie < 4; tie++) {
        for (k = 1; k <= 6; k++) up[k] = c[corner[k]] < 0
        if (c[1] == 0) up[2] = tie % 2
        if (c[5] == 0) up[5] = tie >= 2
        n = 0
        for (k = 1; k <= 6; k++) n += up[k] != up[k % 6 + 1]
        if (n != 2) return 1
    }
    return 0
}

# The configuration as seen from neighbour `first` on, all the way round.
function code(first, step,    k, s) {
    for (k = 0; k < 8; k++) s = s (is_in(first + step * k) ? at(first + step * k) + 2 : OUT)
    return s
}
function canonical(    k, s, least) {
    for (k = 0; k < 8; k += 2) {
        s = code(k, 1); if (least == "" || s < least) least = s
        s = code(k, -1); if (s < least) least = s
    }
    return least
}

function put(x, y, label) { print x + 4 * (classes % columns), y - 4 * int(classes / columns), label }
function draw(    k) {
    for (k = 0; k < 8; k++) if (is_in(k)) {
        put(k < 2 || k == 7 ? 1 : k > 2 && k < 6 ? -1 : 0, k > 0 && k < 4 ? 1 : k > 4 ? -1 : 0, c[k])
        print ""
    }
    put(0, 0, 0); print ""
    for (k = 0; k <= 4; k++) put(k % 4 < 2 ? -1.5 : 1.5, k % 4 == 0 || k % 4 == 3 ? -1.5 : 1.5, "neighbours")
    print ""
    for (k = 0; k <= 4; k++) put(k % 4 < 2 ? -0.5 : 0.5, k % 4 == 0 || k % 4 == 3 ? -0.5 : 0.5, "v")
    print ""
    classes++
}
