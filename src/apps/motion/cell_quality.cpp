// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/cell_quality.h>

#include <apps/motion/dihedral.h>
#include <apps/motion/vectors_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace annulus::inline v1 {

namespace {

constexpr double to_degrees = 180 / std::numbers::pi;

double length(const Coordinates<3>& v) { return std::hypot(v[0], v[1], v[2]); }

/// Exact to rounding for small angles, too, unlike the arc cosine.
double angle_at(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c) {
    const Coordinates<3> u = minus(b, a), v = minus(c, a);
    return std::atan2(length(cross(u, v)), dot(u, v)) * to_degrees;
}

double least_angle(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c) {
    return std::min({angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)});
}

/// longest / (factor * radius).
double ratio_to(double longest, double factor, double radius) {
    return radius > 0 ? longest / (factor * radius) : std::numeric_limits<double>::infinity();
}

}  // namespace

Triangle_quality triangle_quality(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c) {
    const std::array<double, 3> edge{distance(a, b), distance(b, c), distance(c, a)};
    const double around = edge[0] + edge[1] + edge[2], area = length(cross(minus(b, a), minus(c, a))) / 2;
    const double inner = 2 * area / around, outer = edge[0] * edge[1] * edge[2] / (4 * area);
    return {.radius_ratio = area > 0 ? 2 * inner / outer : 0,
            .aspect = ratio_to(*std::max_element(edge.begin(), edge.end()), 2 * std::numbers::sqrt3, inner),
            .angle_min = least_angle(a, b, c)};
}

Cell_quality cell_quality(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c,
                          const Coordinates<3>& d) {
    const Coordinates<3> u = minus(b, a), v = minus(c, a), w = minus(d, a);
    const Coordinates<3> vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
    const double volume = std::abs(dot(u, vw)) / 6;
    const double surface = (length(vw) + length(wu) + length(uv) + length(cross(minus(c, b), minus(d, b)))) / 2;
    Coordinates<3> to_centre{};  // times 12 volumes
    for (std::size_t k = 0; k < 3; ++k) to_centre[k] = dot(u, u) * vw[k] + dot(v, v) * wu[k] + dot(w, w) * uv[k];
    const double inner = 3 * volume / surface, outer = length(to_centre) / (12 * volume);
    const double longest =
        std::max({distance(a, b), distance(a, c), distance(a, d), distance(b, c), distance(b, d), distance(c, d)});
    Cell_quality q{.volume = volume,
                   .radius_ratio = volume > 0 ? 3 * inner / outer : 0,
                   .aspect = ratio_to(longest, 2 * std::sqrt(6.0), inner),
                   .dihedral_min = 180,
                   .dihedral_max = 0,
                   .plane_min = std::min(
                       {least_angle(a, b, c), least_angle(a, b, d), least_angle(a, c, d), least_angle(b, c, d)})};
    for (const double cosine : dihedral_cosines(a, b, c, d)) {
        const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) * to_degrees;
        q.dihedral_min = std::isnan(cosine) ? 0 : std::min(q.dihedral_min, angle);
        q.dihedral_max = std::isnan(cosine) ? 180 : std::max(q.dihedral_max, angle);
    }
    return q;
}

std::vector<std::size_t> worst_cells(std::span<const Cell_quality> cells, std::size_t count) {
    std::vector<std::size_t> order(cells.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    count = std::min(count, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                      [&](std::size_t i, std::size_t j) {
                          const double x = cells[i].dihedral_min, y = cells[j].dihedral_min;
                          return x != y ? x < y : i < j;
                      });
    order.resize(count);
    return order;
}

}  // namespace annulus::inline v1
