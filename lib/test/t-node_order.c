/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables that Gmsh and VTK print for their own elements; and every node once, at every degree. */
#include "node_order.h"

#include "testing.h"

#include <string.h>

enum { DEGREE_MAX = 15, NODES_MAX = (DEGREE_MAX + 1) * (DEGREE_MAX + 2) / 2 };

static void is_order(int degree, enum node_interior interior, const char *expected) {
    int weight[NODES_MAX][3], n = (degree + 1) * (degree + 2) / 2;
    char text[4 * NODES_MAX], *end = text;
    node_order(degree, interior, weight);
    for (int q = 0; q < n; q++) {
        for (int m = 0; m < 3; m++) *end++ = (char)('0' + weight[q][m]);
        *end++ = q + 1 < n ? ' ' : '\0';
    }
    assert_string_equal(text, expected);
}

/* vtkHigherOrderTriangle::BarycentricIndex, and the same in Gmsh's table of triangles. */
static void nested(void **state) {
    (void)state;
    is_order(1, NODE_NESTED, "100 010 001");
    is_order(2, NODE_NESTED, "200 020 002 110 011 101");
    is_order(3, NODE_NESTED, "300 030 003 210 120 021 012 102 201 111");
    is_order(4, NODE_NESTED, "400 040 004 310 220 130 031 022 013 103 202 301 211 121 112");
    is_order(5, NODE_NESTED,
             "500 050 005 410 320 230 140 041 032 023 014 104 203 302 401 "
             "311 131 113 221 122 212");
    is_order(6, NODE_NESTED,
             "600 060 006 510 420 330 240 150 051 042 033 024 015 105 204 303 402 501 "
             "411 141 114 321 231 132 123 213 312 222");
}

/* vtkHigherOrderWedge::PointIndexFromIJK, i and j being the weights of the corners 1 and 2. */
static void rows(void **state) {
    (void)state;
    is_order(1, NODE_ROWS, "100 010 001");
    is_order(2, NODE_ROWS, "200 020 002 110 011 101");
    is_order(4, NODE_ROWS, "400 040 004 310 220 130 031 022 013 103 202 301 211 121 112");
    is_order(5, NODE_ROWS,
             "500 050 005 410 320 230 140 041 032 023 014 104 203 302 401 "
             "311 221 131 212 122 113");
}

static void every_node_once(void **state) {
    (void)state;
    for (int degree = 1; degree <= DEGREE_MAX; degree++)
        for (int way = 0; way < 2; way++) {
            int weight[NODES_MAX][3], n = (degree + 1) * (degree + 2) / 2;
            bool seen[DEGREE_MAX + 1][DEGREE_MAX + 1] = {{false}};
            node_order(degree, way ? NODE_ROWS : NODE_NESTED, weight);
            for (int q = 0; q < n; q++) {
                const int *w = weight[q];
                assert_true(w[0] >= 0 && w[1] >= 0 && w[2] >= 0);
                assert_int_equal(w[0] + w[1] + w[2], degree);
                assert_false(seen[w[0]][w[1]]);
                seen[w[0]][w[1]] = true;
            }
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nested),
        cmocka_unit_test(rows),
        cmocka_unit_test(every_node_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
