// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/motion/moments_2.h>

#include <annulus/motion/boundary_nodes.h>
#include <annulus/motion/moments_sin2.h>

namespace annulus {

namespace {

/// A density along the ray from the cell's origin c to c + e: value at c + t e is q0 + q1 t + q2 t^2.
struct Quadratic {
    double q0, q1, q2;
};

template <Density density>
Quadratic along_ray(const Coordinates<2>& c, const Coordinates<2>& e) {
    if constexpr (density == Density::one) return {1, 0, 0};
    else if constexpr (density == Density::x2) return {c[0] * c[0], 2 * c[0] * e[0], e[0] * e[0]};
    else return {c[0] * c[0] + c[1] * c[1], 2 * (c[0] * e[0] + c[1] * e[1]), e[0] * e[0] + e[1] * e[1]};
}

/// Sum over the cones from c to the pieces of the boundary: the integral over a cone is that of
/// t (q0 + q1 t + q2 t^2) (1, t e) dt cross(e, de) over 0 <= t <= 1 and the piece.
template <Density density>
Moments_2 cone_moments(const Coordinates<2>& c, std::span<const Corner_2> corners) {
    Moments_2 sum;
    const auto node = [&](const Coordinates<2>& e, const Coordinates<2>& d) {
        const double w = e[0] * d[1] - e[1] * d[0];
        const Quadratic q = along_ray<density>(c, e);
        sum.mass += w * (q.q0 / 2 + q.q1 * (1.0 / 3) + q.q2 / 4);
        const double first = w * (q.q0 * (1.0 / 3) + q.q1 / 4 + q.q2 * (1.0 / 5));
        sum.first[0] += first * e[0];
        sum.first[1] += first * e[1];
    };
    // On a straight edge cross(e, de) is constant and first * e at most cubic: two nodes are exact (one for mass = 1).
    const Gauss_rule& rule = gauss_rule(density == Density::one ? 1 : 2);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Coordinates<2>& a = corners[i].offset;
        const Coordinates<2>& b = corners[i + 1 < corners.size() ? i + 1 : 0].offset;
        if (corners[i].arc) arc_nodes(c, a, b, node);
        else edge_nodes(a, b, rule, 1, node);
    }
    return sum;
}

}  // namespace

Moments_2 moments(Density density, const Coordinates<2>& origin, std::span<const Corner_2> corners) {
    if (corners.size() < 2) return {};
    switch (density) {
        case Density::one: return cone_moments<Density::one>(origin, corners);
        case Density::x2_plus_y2: return cone_moments<Density::x2_plus_y2>(origin, corners);
        case Density::x2: return cone_moments<Density::x2>(origin, corners);
        case Density::sin2: return sin2_moments(origin, corners);
    }
    return {};
}

}  // namespace annulus
