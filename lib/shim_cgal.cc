// SPDX-License-Identifier: GPL-3.0-or-later
//
// All points go first into a Delaunay triangulation, then the sides. A side that crosses another
// throws; one that runs through a point is split there by CGAL, so it is not one edge afterwards.
// What lies left and right of the sides is then found by a flood from infinity that counts how
// often the sides go round:
//
//         0   side u->v         crossing u->v from its left to its right: winding - 1,
//     u -------------> v        from right to left: + 1. Loops are closed, so the count does not
//         1                     depend on the way.
//
// The domain is covered once and on the left exactly if every side has 1 on its left, 0 on its
// right.
#include "shim_cgal.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <vector>

namespace {

constexpr uint32_t NONE = UINT32_MAX;
constexpr int UNKNOWN = INT_MIN;

struct Number {
    uint32_t value = NONE;
};
struct Winding {
    int value = UNKNOWN;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<Number, Kernel>;
using Constrained_base = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Winding_base = CGAL::Triangulation_face_base_with_info_2<Winding, Kernel, Constrained_base>;
using Face_base = CGAL::Delaunay_mesh_face_base_2<Kernel, Winding_base>;
using Structure = CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
using Vertex = Triangulation::Vertex_handle;
using Face = Triangulation::Face_handle;

struct Stop {
    enum shim_cgal_status status;
    size_t first, second;
    int winding;
};

[[noreturn]] void stop(enum shim_cgal_status status, size_t first = 0, size_t second = 0,
                       int winding = 0) {
    throw Stop{status, first, second, winding};
}

// Too large, or with a small angle: area of the (rounded) triangle first, then the angle, worst
// first.
class Criteria {
  public:
    struct Quality {
        double size = 0, sine2 = 1; // area over its limit; of the least angle
        bool operator<(const Quality &q) const {
            if (size > 1 || q.size > 1) return size > q.size;
            return sine2 < q.sine2;
        }
    };

    class Is_bad {
      public:
        explicit Is_bad(const shim_cgal_criteria &limits) : limit(limits) {}

        CGAL::Mesh_2::Face_badness operator()(const Quality &q) const {
            if (q.size > 1) return CGAL::Mesh_2::IMPERATIVELY_BAD;
            return q.sine2 < limit.sine2 ? CGAL::Mesh_2::BAD : CGAL::Mesh_2::NOT_BAD;
        }

        CGAL::Mesh_2::Face_badness operator()(const Face &f, Quality &q) const {
            const Point &a = f->vertex(0)->point(), &b = f->vertex(1)->point(),
                        &c = f->vertex(2)->point();
            q.size = std::fabs(area2(rounded(a), rounded(b), rounded(c))) / 2 / limit.max_area;
            q.sine2 = least_sine2(a, b, c);
            return (*this)(q);
        }

      private:
        const shim_cgal_criteria &limit;

        Point rounded(const Point &p) const {
            if (!limit.integers) return p;
            return Point(std::floor(p.x() + 0.5), std::floor(p.y() + 0.5));
        }

        static double area2(const Point &a, const Point &b, const Point &c) {
            return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
        }

        static double distance2(const Point &a, const Point &b) {
            double dx = a.x() - b.x(), dy = a.y() - b.y();
            return dx * dx + dy * dy;
        }

        // The least angle lies between the two longest edges: sine = 2 area / (their lengths).
        static double least_sine2(const Point &a, const Point &b, const Point &c) {
            std::array<double, 3> d{distance2(b, c), distance2(c, a), distance2(a, b)};
            double area = area2(a, b, c);
            std::sort(d.begin(), d.end());
            return area * area / (d[1] * d[2]);
        }
    };

    explicit Criteria(const shim_cgal_criteria &limits) : limit(limits) {}
    Is_bad is_bad_object() const { return Is_bad(limit); }

  private:
    const shim_cgal_criteria &limit;
};

using Mesher = CGAL::Delaunay_mesher_2<Triangulation, Criteria>;

std::vector<Vertex> insert_points(Triangulation &t, const double (*point)[2], size_t n) {
    std::vector<Point> points;
    std::vector<size_t> order(n);
    std::vector<Vertex> vertex(n);
    std::array<size_t, 2> same{n, n};
    Face hint;
    points.reserve(n);
    for (size_t i = 0; i < n; i++) {
        points.emplace_back(point[i][0], point[i][1]);
        order[i] = i;
    }
    auto map = CGAL::make_property_map(points);
    CGAL::spatial_sort(order.begin(), order.end(),
                       CGAL::Spatial_sort_traits_adapter_2<Kernel, decltype(map)>(map));
    for (size_t i : order) {
        Vertex v = t.insert(points[i], hint);
        uint32_t &number = v->info().value, before = number;
        hint = v->face();
        vertex[i] = v;
        number = std::min(number, static_cast<uint32_t>(i));
        if (before != NONE)
            same = std::min(same, {std::min<size_t>(before, i), std::max<size_t>(before, i)});
    }
    if (same[0] < n) stop(SHIM_CGAL_SAME_POINT, same[0], same[1]);
    if (t.dimension() < 2) stop(SHIM_CGAL_FLAT);
    return vertex;
}

void insert_sides(Triangulation &t, const std::vector<Vertex> &vertex,
                  const shim_cgal_sides &sides) {
    Face f;
    int e = 0;
    for (size_t s = 0; s < sides.side_count; s++) try {
            t.insert_constraint(vertex[sides.side[s][0]], vertex[sides.side[s][1]]);
        } catch (const Triangulation::Intersection_of_constraints_exception &) {
            stop(SHIM_CGAL_TOUCH, s);
        }
    for (size_t s = 0; s < sides.side_count; s++)
        if (!t.is_edge(vertex[sides.side[s][0]], vertex[sides.side[s][1]], f, e))
            stop(SHIM_CGAL_TOUCH, s);
}

std::vector<Vertex> insert(Triangulation &t, const shim_cgal_sides &sides) {
    std::vector<Vertex> vertex = insert_points(t, sides.point, sides.point_count);
    insert_sides(t, vertex, sides);
    return vertex;
}

// Gives f and all faces that can be reached from it their winding. next[v] ends the side that
// begins at v.
void flood_winding(Face start, const std::vector<uint32_t> &next) {
    std::vector<Face> todo{start};
    start->info().value = 0;
    while (!todo.empty()) {
        Face f = todo.back();
        todo.pop_back();
        for (int e = 0; e < 3; e++) {
            Face g = f->neighbor(e);
            int step = 0;
            if (g->info().value != UNKNOWN) continue;
            if (f->is_constrained(e)) { // f lies left of the edge from its vertex ccw(e) to cw(e)
                uint32_t from = f->vertex(CGAL::Triangulation_cw_ccw_2::ccw(e))->info().value;
                uint32_t to = f->vertex(CGAL::Triangulation_cw_ccw_2::cw(e))->info().value;
                step = next[from] == to ? -1 : 1;
            }
            g->info().value = f->info().value + step;
            todo.push_back(g);
        }
    }
}

void mark_by_winding(Triangulation &t, const std::vector<Vertex> &vertex,
                     const shim_cgal_sides &sides) {
    std::vector<uint32_t> next(sides.point_count, NONE);
    Face left;
    int e = 0;
    for (size_t s = 0; s < sides.side_count; s++) next[sides.side[s][0]] = sides.side[s][1];
    flood_winding(t.infinite_face(), next);
    for (size_t s = 0; s < sides.side_count; s++) {
        t.is_edge(vertex[sides.side[s][1]], vertex[sides.side[s][0]], left, e);
        if (left->info().value != 1) stop(SHIM_CGAL_WINDING, s, 0, left->info().value);
    }
    for (Face f : t.all_face_handles()) f->set_in_domain(f->info().value == 1);
}

void mark_by_seeds(Triangulation &t, const double (*seed)[2], size_t n) {
    std::vector<Point> seeds;
    for (size_t i = 0; i < n; i++) seeds.emplace_back(seed[i][0], seed[i][1]);
    for (Face f : t.all_face_handles()) f->set_in_domain(true);
    Mesher::propagate_marks(t.infinite_face(), false);
    for (const Point &p : seeds) {
        Face f = t.locate(p);
        if (f != nullptr && f->is_in_domain()) Mesher::propagate_marks(f, false);
    }
}

size_t count_domain(const Triangulation &t) {
    size_t n = 0;
    for (Face f : t.finite_face_handles()) n += f->is_in_domain();
    return n;
}

// A point more makes one or two triangles more, so they are counted again only where two a point
// could have reached the limit.
void refine(Triangulation &t, const shim_cgal_criteria &limits) {
    Mesher mesher(t, Criteria(limits));
    size_t triangles = count_domain(t), points = t.number_of_vertices();
    mesher.init(true);
    while (triangles <= limits.max_triangles && mesher.step_by_step_refine_mesh()) {
        if (t.number_of_vertices() == points) stop(SHIM_CGAL_PRECISION);
        points = t.number_of_vertices();
        triangles += 2;
        if (triangles > limits.max_triangles) triangles = count_domain(t);
    }
    if (triangles > limits.max_triangles) stop(SHIM_CGAL_LIMIT);
}

template <class T> T *allocate(size_t n) {
    void *p = std::calloc(n ? n : 1, sizeof(T));
    if (!p) throw std::bad_alloc();
    return static_cast<T *>(p);
}

// Numbers the Steiner points behind the given ones.
std::vector<Vertex> number_vertices(Triangulation &t, std::vector<Vertex> vertex) {
    size_t given = vertex.size();
    for (Vertex v : t.finite_vertex_handles())
        if (v->info().value == NONE) vertex.push_back(v);
    std::sort(vertex.begin() + static_cast<std::ptrdiff_t>(given), vertex.end(),
              [](Vertex a, Vertex b) { return a->point() < b->point(); });
    for (size_t i = given; i < vertex.size(); i++)
        vertex[i]->info().value = static_cast<uint32_t>(i);
    return vertex;
}

std::vector<std::array<uint32_t, 3>> sorted_triangles(const Triangulation &t) {
    std::vector<std::array<uint32_t, 3>> triangles;
    for (Face f : t.finite_face_handles()) {
        if (!f->is_in_domain()) continue;
        std::array<uint32_t, 3> v;
        for (int c = 0; c < 3; c++) v[static_cast<size_t>(c)] = f->vertex(c)->info().value;
        std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
        triangles.push_back(v);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

void extract(Triangulation &t, std::vector<Vertex> given, shim_cgal_mesh &mesh) {
    std::vector<Vertex> vertex = number_vertices(t, std::move(given));
    std::vector<std::array<uint32_t, 3>> triangle = sorted_triangles(t);
    mesh.vertex_count = vertex.size();
    mesh.triangle_count = triangle.size();
    mesh.vertex = allocate<double[2]>(vertex.size());
    mesh.triangle = allocate<uint32_t[3]>(triangle.size());
    for (size_t i = 0; i < vertex.size(); i++) {
        mesh.vertex[i][0] = vertex[i]->point().x();
        mesh.vertex[i][1] = vertex[i]->point().y();
    }
    for (size_t i = 0; i < triangle.size(); i++)
        std::copy(triangle[i].begin(), triangle[i].end(), mesh.triangle[i]);
}

// While it lives, CGAL throws and prints nothing.
class Quiet {
  public:
    Quiet()
        : error(CGAL::set_error_handler(&ignore)), warning(CGAL::set_warning_handler(&ignore)),
          behaviour(CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION)) {}
    ~Quiet() {
        CGAL::set_error_handler(error);
        CGAL::set_warning_handler(warning);
        CGAL::set_error_behaviour(behaviour);
    }
    Quiet(const Quiet &) = delete;
    Quiet &operator=(const Quiet &) = delete;

  private:
    static void ignore(const char *, const char *, const char *, int, const char *) {}
    CGAL::Failure_function error, warning;
    CGAL::Failure_behaviour behaviour;
};

bool failed(shim_cgal_report *report, enum shim_cgal_status status, const char *message) {
    report->status = status;
    std::snprintf(report->message, sizeof report->message, "%s", message);
    return false;
}

// The border: runs the work and turns whatever it throws into a report.
template <class Work> bool guarded(shim_cgal_report *report, Work work) {
    *report = shim_cgal_report{};
    try {
        Quiet quiet;
        work();
        return true;
    } catch (const Stop &s) {
        report->at[0] = s.first;
        report->at[1] = s.second;
        report->winding = s.winding;
        return failed(report, s.status, "");
    } catch (const std::bad_alloc &) {
        return failed(report, SHIM_CGAL_MEMORY, "out of memory");
    } catch (const std::exception &e) {
        return failed(report, SHIM_CGAL_BUG, e.what());
    } catch (...) {
        return failed(report, SHIM_CGAL_BUG, "unknown exception");
    }
}

// The same where a mesh is made: on failure it is released.
template <class Work> bool meshed(shim_cgal_mesh *mesh, shim_cgal_report *report, Work work) {
    *mesh = shim_cgal_mesh{};
    if (guarded(report, work)) return true;
    std::free(mesh->vertex);
    std::free(mesh->triangle);
    *mesh = shim_cgal_mesh{};
    return false;
}

} // namespace

bool shim_cgal_check(const shim_cgal_sides *sides, shim_cgal_report *report) {
    return guarded(report, [&] {
        Triangulation t;
        mark_by_winding(t, insert(t, *sides), *sides);
    });
}

bool shim_cgal_domain(const shim_cgal_sides *sides, const shim_cgal_criteria *criteria,
                      shim_cgal_mesh *mesh, shim_cgal_report *report) {
    return meshed(mesh, report, [&] {
        Triangulation t;
        std::vector<Vertex> vertex = insert(t, *sides);
        mark_by_winding(t, vertex, *sides);
        if (criteria) refine(t, *criteria);
        extract(t, std::move(vertex), *mesh);
    });
}

bool shim_cgal_regions(const shim_cgal_sides *sides, const double (*seed)[2], size_t seed_count,
                       shim_cgal_mesh *mesh, shim_cgal_report *report) {
    return meshed(mesh, report, [&] {
        Triangulation t;
        std::vector<Vertex> vertex = insert(t, *sides);
        mark_by_seeds(t, seed, seed_count);
        extract(t, std::move(vertex), *mesh);
    });
}

bool shim_cgal_delaunay(const double (*point)[2], size_t n, shim_cgal_mesh *mesh,
                        shim_cgal_report *report) {
    return meshed(mesh, report, [&] {
        Triangulation t;
        std::vector<Vertex> vertex = insert_points(t, point, n);
        for (Face f : t.finite_face_handles()) f->set_in_domain(true);
        extract(t, std::move(vertex), *mesh);
    });
}
