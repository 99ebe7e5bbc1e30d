// SPDX-License-Identifier: GPL-3.0-or-later
// What CGAL needs to find the triangles of the points that locate.c asks for, in the Delaunay
// triangulation of the vertices "x y" on stdin: from the face before, and by a hierarchy.
//
//     raster NS
//     shuffled NS
//     raster-hierarchy NS
//     shuffled-hierarchy NS
//
// usage: cgal_locate X0 Y0 X1 Y1 <VERTICES
#include "points.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_hierarchy_2.h>
#include <algorithm>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex =
    CGAL::Triangulation_hierarchy_vertex_base_2<CGAL::Triangulation_vertex_base_2<Kernel>>;
using Plain = CGAL::Delaunay_triangulation_2<Kernel>;
using Levels = CGAL::Triangulation_hierarchy_2<
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>>;

template <class T> double measure(const T &t, const std::vector<point> &points, bool hint) {
    double best = 1e9;
    size_t finite = 0;
    for (int run = 0; run < RUNS; run++) {
        double start = seconds();
        typename T::Face_handle face;
        for (const point &p : points) {
            face = t.locate({p.x, p.y}, hint ? face : typename T::Face_handle());
            finite += !t.is_infinite(face);
        }
        best = std::min(best, seconds() - start);
    }
    if (finite != RUNS * points.size()) std::cerr << "points outside\n";
    return best / POINT_COUNT * 1e9;
}

int main(int argc, char **argv) {
    std::vector<Kernel::Point_2> vertices;
    std::vector<point> points(POINT_COUNT);
    double box[4], x, y;
    if (argc != 5) return 2;
    for (int i = 0; i < 4; i++) box[i] = atof(argv[1 + i]);
    while (std::cin >> x >> y) vertices.emplace_back(x, y);
    Plain plain(vertices.begin(), vertices.end());
    Levels levels(vertices.begin(), vertices.end());
    for (int shuffled = 0; shuffled < 2; shuffled++) {
        const char *name = shuffled ? "shuffled" : "raster";
        make_points(points.data(), box, shuffled);
        std::cout << name << ' ' << measure(plain, points, true) << '\n'
                  << name << "-hierarchy " << measure(levels, points, false) << '\n';
    }
}
