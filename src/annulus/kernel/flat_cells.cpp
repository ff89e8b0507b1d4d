// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/flat_cells.h>

#include <annulus/arithmetic/collision.h>
#include <annulus/kernel/bounding_box.h>
#include <annulus/kernel/builder.h>
#include <annulus/mesh/degenerate.h>
#include <annulus/mesh/walk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace annulus {

namespace {

/// The coordinate that a plane through p, a and b has different values of along a line parallel to its axis; nothing where
/// the three are on a line.
std::optional<std::size_t> axis_across(const Coordinates<3>& p, const Coordinates<3>& a, const Coordinates<3>& b) {
    for (std::size_t i = 0; i < 3; ++i) {
        const auto y = seen_along<3>(i, {&p, &a, &b});
        if (sure_orientation<2>({&y[0], &y[1], &y[2]}) != 0) return i;
    }
    return std::nullopt;
}

/// Another value than c, some `distance` away, no further from 0 than the larger of them.
double beside(double c, double distance) {
    const double other = c > 0 ? c - distance : c + distance;
    return other != c ? other : std::nextafter(c, c > 0 ? 0.0 : 1.0);
}

/// With a point outside of the plane, every cell is the cone from there to a Delaunay triangle: its sphere cuts the plane
/// in the circle of the triangle.
void triangles(std::span<const Coordinates<3>> x, std::vector<Index> vertices, std::size_t axis,
               std::vector<Index>& cells) {
    std::vector<Coordinates<3>> with_apex(x.begin(), x.end());
    Coordinates<3> apex = x[static_cast<std::size_t>(vertices[0])];
    apex[axis] = beside(apex[axis], Bounding_box<3>(x, vertices).extent() / 2);
    const auto top = static_cast<Index>(x.size());
    with_apex.push_back(apex);
    vertices.push_back(top);
    Builder<3> builder;
    (void)builder.build(with_apex, std::move(vertices));
    builder.for_each_cell([&](Cell_index, const Cell_points<3>& v, const auto&) {
        if (std::find(v.begin(), v.end(), infinite) != v.end()) return;
        // All turned the same way, as they are seen from the apex.
        constexpr std::array<std::array<std::size_t, 3>, 4> others{{{1, 2, 3}, {0, 3, 2}, {3, 0, 1}, {2, 1, 0}}};
        const auto slot = static_cast<std::size_t>(std::find(v.begin(), v.end(), top) - v.begin());
        for (const std::size_t k : others[slot]) cells.push_back(v[k]);
        cells.push_back(none);
    });
}

}  // namespace

template <int d>
int flat_cells(std::span<const Coordinates<d>> x, std::vector<Index> vertices, std::vector<Index>& cells) {
    const auto at = [x](Index i) -> const Coordinates<d>& { return x[static_cast<std::size_t>(i)]; };
    std::sort(vertices.begin(), vertices.end(),
              [&at](Index l, Index r) { return at(l) != at(r) ? at(l) < at(r) : l < r; });
    const auto twice =
        std::adjacent_find(vertices.begin(), vertices.end(), [&at](Index l, Index r) { return at(l) == at(r); });
    if (twice != vertices.end()) throw collision_of("points", "have", *twice, *(twice + 1));
    if (vertices.size() < 2) return static_cast<int>(vertices.size()) - 1;
    if constexpr (d == 3)
        for (const Index v : vertices)
            if (const auto axis = axis_across(at(vertices[0]), at(vertices[1]), at(v))) {
                triangles(x, std::move(vertices), *axis, cells);
                return 2;
            }
    for (std::size_t k = 1; k < vertices.size(); ++k) {
        cells.insert(cells.end(), {vertices[k - 1], vertices[k]});
        cells.resize(cells.size() + d - 1, none);
    }
    return 1;
}

template int flat_cells<2>(std::span<const Coordinates<2>>, std::vector<Index>, std::vector<Index>&);
template int flat_cells<3>(std::span<const Coordinates<3>>, std::vector<Index>, std::vector<Index>&);

}  // namespace annulus
