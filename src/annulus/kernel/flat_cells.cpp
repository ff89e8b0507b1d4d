// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/flat_cells.h>

#include <annulus/arithmetic/duplicate_point.h>
#include <annulus/kernel/axis_across.h>
#include <annulus/kernel/bounding_box.h>
#include <annulus/kernel/builder.h>
#include <annulus/predicate/sure_orientation.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// A value other than c, about `distance` away, not further from 0 than the larger of the two.
double beside(double c, double distance) {
    const double other = c > 0 ? c - distance : c + distance;
    return other != c ? other : std::nextafter(c, c > 0 ? 0.0 : 1.0);
}

/// Sorts vertices by position.
template <int d>
void sort_by_position(std::span<const Coordinates<d>> x, std::vector<Index>& vertices) {
    const auto key = [x](Index i) -> const Coordinates<d>& { return x[static_cast<std::size_t>(i)]; };
    std::sort(vertices.begin(), vertices.end(),
              [&key](Index l, Index r) { return key(l) != key(r) ? key(l) < key(r) : l < r; });
}

/// Makes the cells of a ring that runs from infinity along the line and back. Cell k is {ring k, ring k + 1}.
void segments(const std::vector<Index>& along, Flat_cells& out) {
    const auto n = static_cast<Index>(along.size()) + 1;  // of the ring
    const auto ring = [&](Index k) { return k % n == 0 ? infinite : along[static_cast<std::size_t>(k % n) - 1]; };
    for (Index k = 0; k < n; ++k) {
        out.vertices.push_back({ring(k), ring(k + 1), none});
        out.neighbours.push_back({(k + 1) % n, (k + n - 1) % n, none});
    }
}

/// Adds a point outside the plane, the apex. Every finite cell is then the cone from it to a Delaunay triangle: its
/// sphere cuts the plane in the circle of the triangle. So the triangles, and the infinite cells, are the facets that
/// the cells around the apex turn away from it.
void triangles(std::span<const Coordinates<3>> x, std::vector<Index> vertices, std::size_t axis, Flat_cells& out) {
    std::vector<Coordinates<3>> with_apex(x.begin(), x.end());
    Coordinates<3> apex = x[static_cast<std::size_t>(vertices[0])];
    apex[axis] = beside(apex[axis], Bounding_box<3>(x, vertices).extent() / 2);
    const auto top = static_cast<Index>(x.size());
    with_apex.push_back(apex);
    vertices.push_back(top);
    Builder<3> builder;
    (void)builder.build(with_apex, vertices);
    Corner_table<3> table;
    builder.copy_to(table, with_apex.size());
    By_cell<Index> number(table.cell_bound().offset(), none);
    Index count = 0;
    for (const Cell_index c : table.cells())
        if (table.slot(c, Site<3>(top)) >= 0) number[c] = count++;
    for (const Cell_index c : table.cells()) {
        const int slot = table.slot(c, Site<3>(top));
        if (slot < 0) continue;
        auto& corners = out.vertices.emplace_back();
        auto& beyond = out.neighbours.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const Corner_index h = table.corner(c, facing_corners[static_cast<std::size_t>(slot)][k]);
            corners[k] = table.vertex(h);
            beyond[k] = number[table.cell_of(table.twin(h))];
        }
    }
}

}  // namespace

template <int d>
void require_distinct(std::span<const Coordinates<d>> x, std::vector<Index> vertices) {
    sort_by_position<d>(x, vertices);
    const auto at = [x](Index i) { return x[static_cast<std::size_t>(i)]; };
    const auto twice =
        std::adjacent_find(vertices.begin(), vertices.end(), [&at](Index l, Index r) { return at(l) == at(r); });
    if (twice != vertices.end()) throw duplicate_point_error("points", "have", {*twice, *(twice + 1)});
}

template <int d>
bool spans_more(std::span<const Coordinates<d>* const> independent, const Coordinates<d>& p) {
    const auto& q = independent;
    if (q.empty()) return true;
    if (q.size() == 1) return *q[0] != p;
    if constexpr (d == 2) return sure_orientation<2>({q[0], q[1], &p}) != 0;
    else if (q.size() == 2) return axis_across(*q[0], *q[1], p).has_value();
    else return sure_orientation<3>({q[0], q[1], q[2], &p}) != 0;
}

template <int d>
Flat_cells flat_cells(std::span<const Coordinates<d>> x, std::vector<Index> vertices) {
    Flat_cells out;
    out.dimension = std::min(static_cast<int>(vertices.size()), 2) - 1;
    if (out.dimension < 1) return out;
    sort_by_position<d>(x, vertices);
    if constexpr (d == 3) {
        const auto at = [x](Index i) -> const Coordinates<d>& { return x[static_cast<std::size_t>(i)]; };
        for (const Index v : vertices)
            if (const auto axis = axis_across(at(vertices[0]), at(vertices[1]), at(v))) {
                out.dimension = 2;
                triangles(x, std::move(vertices), *axis, out);
                return out;
            }
    }
    segments(vertices, out);
    return out;
}

#define ANNULUS_FLAT(d)                                                                     \
    template Flat_cells flat_cells<d>(std::span<const Coordinates<d>>, std::vector<Index>); \
    template void require_distinct<d>(std::span<const Coordinates<d>>, std::vector<Index>); \
    template bool spans_more<d>(std::span<const Coordinates<d>* const>, const Coordinates<d>&);
ANNULUS_FLAT(2)
ANNULUS_FLAT(3)
#undef ANNULUS_FLAT

}  // namespace annulus::inline v1
