// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/motion/moments_sin2.h>

#include <annulus/motion/boundary_nodes.h>
#include <annulus/motion/moments_sin2_far.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace annulus {

namespace {

double norm(const Coordinates<2>& p) { return std::sqrt(p[0] * p[0] + p[1] * p[1]); }

/// For r < 1, from sin^2 t = sum over j >= 1 of -(-4)^j t^(2j) / (2 (2j)!), term by term.
Radial_means sin2_series(double r) {
    const double z = r * r;
    double term = 1, g = 0, h = 0;  // term = -(-4)^j z^j / (2 (2j)!)
    for (int j = 1; j <= 11; ++j) {
        term = j == 1 ? z : term * (-4 * z) / (2 * j * (2 * j - 1));
        g += term / (2 * j + 2);
        h += term / (2 * j + 3);
    }
    return {g, h};
}

}  // namespace

Radial_means cos2_means(double r) {
    if (r < 1) {
        const Radial_means s = sin2_series(r);  // cos 2t = 1 - 2 sin^2 t
        return {0.5 - 2 * s.g, 1.0 / 3 - 2 * s.h};
    }
    const double s = std::sin(r), c = std::cos(r), sin2 = 2 * s * c, cos2 = (c - s) * (c + s), q = 1 / r;
    return {(sin2 / 2 - s * s * q / 2) * q, (sin2 / 2 + (cos2 / 2 - sin2 * q / 4) * q) * q};
}

Radial_means sin2_means(double r) {
    if (r < 1) return sin2_series(r);
    const Radial_means c = cos2_means(r);
    return {0.25 - c.g / 2, 1.0 / 6 - c.h / 2};
}

namespace {

Size_2 size_of(const Coordinates<2>& c, std::span<const Corner_2> corners) {
    double square = 0, edge2 = 0, bulge = 0, twice = 0;
    bool arcs = false;
    Coordinates<2> a = corners.back().offset;
    for (const Corner_2& corner : corners) {
        const Coordinates<2>& b = corner.offset;
        const double x = b[0] - a[0], y = b[1] - a[1];
        square = std::max(square, b[0] * b[0] + b[1] * b[1]);
        edge2 = std::max(edge2, x * x + y * y);
        twice += a[0] * b[1] - a[1] * b[0];
        arcs = arcs || corner.arc;
        a = b;
    }
    for (std::size_t i = 0; arcs && i < corners.size(); ++i) {
        if (!corners[i].arc) continue;
        const double span = arc_span(c, corners[i].offset, corners[i + 1 < corners.size() ? i + 1 : 0].offset);
        const double r = norm({c[0] + corners[i].offset[0], c[1] + corners[i].offset[1]});
        bulge = std::max(bulge, span < 1 ? r * span * span / 8 : 2 * r);  // sagitta
    }
    return {std::sqrt(square) + bulge, edge2, twice / 2, arcs};
}

/// The fields g(r) p and h(r) (p - c's share) whose divergence is the density and the density times (p - c): the kinds
/// "near" and "large".
template <class Means>
struct From_centre {
    Coordinates<2> c;
    Means means;
    Moments_2 sum{};

    void operator()(const Coordinates<2>& u, const Coordinates<2>& d) {
        const double x = c[0] + u[0], y = c[1] + u[1], turn = x * d[1] - y * d[0];
        const Radial_means m = means(norm({x, y}));
        sum.mass += m.g * turn;
        // h x - g c_x = h u_x + (h - g) c_x
        sum.first[0] += (m.h * u[0] + (m.h - m.g) * c[0]) * turn;
        sum.first[1] += (m.h * u[1] + (m.h - m.g) * c[1]) * turn;
    }
};

/// Runs `node` around the boundary; `pieces_of(length)` says into how many pieces of 10 nodes a straight edge is cut.
template <class Node, class Pieces_of>
void around(const Coordinates<2>& c, std::span<const Corner_2> corners, Node& node, Pieces_of&& pieces_of) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Coordinates<2>& a = corners[i].offset;
        const Coordinates<2>& b = corners[i + 1 < corners.size() ? i + 1 : 0].offset;
        if (corners[i].arc) arc_nodes(c, a, b, node);
        else edge_nodes(a, b, gauss_rule(10), pieces_of(norm({b[0] - a[0], b[1] - a[1]})), node);
    }
}

}  // namespace

Moments_2 sin2_moments(const Coordinates<2>& origin, std::span<const Corner_2> corners) {
    if (corners.empty()) return {};
    const Size_2 size = size_of(origin, corners);
    const double r = norm(origin);
    if (size.radius <= 1.5 && r > 4 * size.radius) return far_sin2_moments(origin, r, corners, size);
    if (size.radius > 1) {
        Moments_2 half = moments(Density::one, origin, corners);
        From_centre<Radial_means (*)(double)> oscillating{origin, cos2_means};
        // 10 nodes on at most 2 units of length: remainder 8e-19. A million pieces at most: see `moments`.
        around(origin, corners, oscillating,
               [](double length) { return 1 + static_cast<int>(std::min(length / 2, 1e6)); });
        return {(half.mass - oscillating.sum.mass) / 2,
                {(half.first[0] - oscillating.sum.first[0]) / 2, (half.first[1] - oscillating.sum.first[1]) / 2}};
    }
    From_centre<Radial_means (*)(double)> near{origin, sin2_means};
    around(origin, corners, near, [](double) { return 1; });
    return near.sum;
}

}  // namespace annulus
