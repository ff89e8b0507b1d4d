// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/surface_faults.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1 {

namespace {

struct Directed_edge {
    std::array<Index, 2> ends;  ///< the lesser first: they are compared most
    bool turned;                ///< whether the triangle runs from the greater to the lesser
    std::size_t triangle;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Corners = std::array<Index, 3>;

class Crossing_test {
  public:
    explicit Crossing_test(const Triangle_surface& s) : surface_(s) {}

    /// Do they meet where they share neither a corner nor an edge?
    [[nodiscard]] bool cross(std::size_t s, std::size_t t) const {
        Corners a = surface_.triangles[s], b = surface_.triangles[t];
        const auto shared = common_corners_first(a, b);
        if (shared == 3) return true;  // one lies on the other
        if (shared == 2) {
            const auto o = [&](Index i) { return point(i); };
            return CGAL::coplanar(o(a[0]), o(a[1]), o(a[2]), o(b[2])) &&
                   CGAL::coplanar_orientation(o(a[0]), o(a[1]), o(a[2]), o(b[2])) == CGAL::POSITIVE;
        }
        if (shared == 1)
            return CGAL::do_intersect(triangle(a), Kernel::Segment_3(point(b[1]), point(b[2]))) ||
                   CGAL::do_intersect(triangle(b), Kernel::Segment_3(point(a[1]), point(a[2])));
        return CGAL::do_intersect(triangle(a), triangle(b));
    }
    [[nodiscard]] Kernel::Triangle_3 triangle(const Corners& c) const {
        return {point(c[0]), point(c[1]), point(c[2])};
    }

  private:
    [[nodiscard]] Kernel::Point_3 point(Index i) const {
        const auto& p = surface_.points[static_cast<std::size_t>(i)];
        return {p[0], p[1], p[2]};
    }
    /// Their number; both begin with them, in the same order.
    static std::size_t common_corners_first(Corners& a, Corners& b) {
        std::size_t n = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto at = std::find(b.begin() + static_cast<std::ptrdiff_t>(n), b.end(), a[i]);
            if (at == b.end()) continue;
            std::swap(*at, b[n]);
            std::swap(a[i], a[n]);
            ++n;
        }
        return n;
    }

    const Triangle_surface& surface_;
};

}  // namespace

std::optional<Edge_fault> edge_fault(const std::vector<std::array<Index, 3>>& triangles) {
    std::vector<Directed_edge> edges;
    edges.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const Index from = triangles[t][i], to = triangles[t][(i + 1) % 3];
            edges.push_back({{std::min(from, to), std::max(from, to)}, from > to, t});
        }
    std::sort(edges.begin(), edges.end(), [&](const Directed_edge& a, const Directed_edge& b) {
        return a.ends != b.ends ? a.ends < b.ends : a.triangle < b.triangle;
    });
    const Directed_edge* open = nullptr;
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t next = i + 1;
        while (next < edges.size() && edges[next].ends == edges[i].ends) ++next;
        if (next - i > 2)
            return Edge_fault{Edge_fault::Kind::crowded, edges[i + 2].triangle, edges[i].triangle, next - i};
        if (next - i == 2 && edges[i].turned == edges[i + 1].turned)
            return Edge_fault{Edge_fault::Kind::turned, edges[i + 1].triangle, edges[i].triangle, 2};
        if (next - i == 1 && (open == nullptr || edges[i].triangle < open->triangle)) open = &edges[i];
        i = next;
    }
    if (open == nullptr) return std::nullopt;
    return Edge_fault{Edge_fault::Kind::open, open->triangle, open->triangle, 1};
}

std::optional<std::size_t> flat_triangle(const Triangle_surface& surface) {
    const Crossing_test test(surface);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        if (test.triangle(surface.triangles[t]).is_degenerate()) return t;
    return std::nullopt;
}

std::optional<std::array<std::size_t, 2>> crossing_triangles(const Triangle_surface& surface) {
    using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
    const Crossing_test test(surface);
    std::vector<Box> boxes;
    boxes.reserve(surface.triangles.size());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        boxes.emplace_back(test.triangle(surface.triangles[t]).bbox(), t);
    std::optional<std::array<std::size_t, 2>> found;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
        const std::array<std::size_t, 2> pair{std::min(a.info(), b.info()), std::max(a.info(), b.info())};
        if (!(found && *found <= pair) && test.cross(pair[0], pair[1])) found = pair;
    });
    return found;
}

}  // namespace annulus::inline v1
