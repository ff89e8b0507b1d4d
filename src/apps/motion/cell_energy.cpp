// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/cell_energy.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace annulus::inline v1 {

namespace {

/// A node by its barycentric coordinates of two corners, and its share of the area.
struct Radon_node {
    double u, v, weight;
};

/// Radon's rule of degree 5 on a triangle.
const std::array<Radon_node, 7>& radon_nodes() {
    static const std::array<Radon_node, 7> all = [] {
        const double root = std::sqrt(15.0);
        const double a = (6 - root) / 21, b = (6 + root) / 21;
        const double wa = (155 - root) / 1200, wb = (155 + root) / 1200;
        return std::array<Radon_node, 7>{{{1.0 / 3, 1.0 / 3, 9.0 / 40},
                                          {a, a, wa},
                                          {1 - 2 * a, a, wa},
                                          {a, 1 - 2 * a, wa},
                                          {b, b, wb},
                                          {1 - 2 * b, b, wb},
                                          {b, 1 - 2 * b, wb}}};
    }();
    return all;
}

}  // namespace

std::vector<Coordinates<2>> outline_of(const Cell_2& cell) {
    constexpr double piece = 0.02;
    std::vector<Coordinates<2>> outline;
    for (std::size_t i = 0; i < cell.corners.size(); ++i) {
        const Corner_2& from = cell.corners[i];
        const Coordinates<2> start{cell.origin[0] + from.offset[0], cell.origin[1] + from.offset[1]};
        outline.push_back(start);
        if (!from.arc) continue;
        const double span = arc_span(cell.origin, from.offset, cell.corners[(i + 1) % cell.corners.size()].offset);
        const int pieces = static_cast<int>(std::ceil(span / piece));
        for (int k = 1; k < pieces; ++k) {
            const double t = span * k / pieces;
            outline.push_back(
                {std::cos(t) * start[0] - std::sin(t) * start[1], std::sin(t) * start[0] + std::cos(t) * start[1]});
        }
    }
    return outline;
}

double cell_energy(const Density_2& density, const Cell_2& cell, const Coordinates<2>& site) {
    const std::vector<Coordinates<2>> outline = outline_of(cell);
    double sum = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Coordinates<2>&p = outline[i], &q = outline[(i + 1) % outline.size()];
        const Coordinates<2> a{p[0] - site[0], p[1] - site[1]}, b{q[0] - site[0], q[1] - site[1]};
        const double area = (a[0] * b[1] - a[1] * b[0]) / 2;
        for (const Radon_node& node : radon_nodes()) {
            const Coordinates<2> at{node.u * a[0] + node.v * b[0], node.u * a[1] + node.v * b[1]};
            sum += area * node.weight * (at[0] * at[0] + at[1] * at[1]) *
                   density_at(density, {site[0] + at[0], site[1] + at[1]});
        }
    }
    return sum;
}

}  // namespace annulus::inline v1
