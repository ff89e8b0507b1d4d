// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/moments_2.h>

#include <apps/motion/boundary_nodes.h>
#include <apps/motion/moments_image.h>
#include <apps/motion/moments_smooth.h>

namespace annulus::inline v1 {

namespace {

/// c . e, and |e|^2, of the quadratic form that the density is: at c + t e it is form(c, c) + 2 t form(c, e) + t^2
/// form(e, e).
template <Density density>
double form(const Coordinates<2>& c, const Coordinates<2>& e) {
    if constexpr (density == Density::x2) return c[0] * e[0];
    else return c[0] * e[0] + c[1] * e[1];
}

/// Adds a node of an arc. The integral over the cone from c to a piece e, e + d of the boundary is that of
/// t (q0 + q1 t + q2 t^2) (1, t e) dt cross(e, d) over 0 <= t <= 1.
template <Density density>
void add_node(const Coordinates<2>& c, const Coordinates<2>& e, const Coordinates<2>& d, Moments_2& sum) {
    const double w = e[0] * d[1] - e[1] * d[0];
    double mass = w / 2, first = w * (1.0 / 3);
    if constexpr (density != Density::one) {
        const double q0 = form<density>(c, c), q1 = 2 * form<density>(c, e), q2 = form<density>(e, e);
        mass = w * (q0 / 2 + q1 * (1.0 / 3) + q2 / 4);
        first = w * (q0 * (1.0 / 3) + q1 / 4 + q2 * (1.0 / 5));
    }
    sum.mass += mass;
    sum.first[0] += first * e[0];
    sum.first[1] += first * e[1];
}

/// Terms that the two straight edges at a corner share.
struct At_corner {
    Coordinates<2> e{};
    double linear = 0, square = 0;  ///< form(c, e), form(e, e)
    double weight = 0;              ///< of e in the first moments
};

template <Density density>
At_corner at_corner(const Coordinates<2>& c, const Coordinates<2>& e) {
    if constexpr (density == Density::one) return {e, 0, 0, 0};
    const double linear = form<density>(c, e), square = form<density>(e, e);
    return {e, linear, square, linear * (1.0 / 12) + square * (1.0 / 30)};
}

/// Sum over the cones from c to the pieces of the boundary. On a straight edge from a to b cross(e, de) is constant
/// and the rest of the integrand at most cubic: Simpson's rule is exact, and its nodes at corners serve two edges.
/// With m = a + b, twice the middle: the integrals over the edge of 1, e, form(c, e), form(e, e), form(c, e) e and
/// form(e, e) e are 1, m / 2, (ca + cb) / 2, (aa + bb + mm) / 6, (ca a + cb b + cm m) / 6 and (aa a + bb b + mm
/// m / 2) / 6.
template <Density density>
Moments_2 cone_moments(const Coordinates<2>& c, std::span<const Corner_2> corners) {
    Moments_2 sum;
    const double q0 = density == Density::one ? 1 : form<density>(c, c);
    const double half = q0 / 2, sixth = q0 * (1.0 / 6);
    At_corner a = at_corner<density>(c, corners.back().offset);
    bool arc = corners.back().arc;
    for (const Corner_2& corner : corners) {
        const At_corner b = at_corner<density>(c, corner.offset);
        if (arc) {
            arc_nodes(c, a.e, b.e, [&](const auto& e, const auto& d) { add_node<density>(c, e, d, sum); });
        } else {
            const double w = a.e[0] * b.e[1] - a.e[1] * b.e[0];
            const Coordinates<2> m{a.e[0] + b.e[0], a.e[1] + b.e[1]};
            if constexpr (density == Density::one) {
                sum.mass += w * half;
                for (std::size_t k = 0; k < 2; ++k) sum.first[k] += w * sixth * m[k];
            } else {
                const double linear = a.linear + b.linear, square = form<density>(m, m);
                const double middle = sixth + linear * (1.0 / 12) + square * (1.0 / 60);
                sum.mass += w * (half + linear * (1.0 / 3) + (a.square + b.square + square) * (1.0 / 24));
                for (std::size_t k = 0; k < 2; ++k)
                    sum.first[k] += w * (middle * m[k] + (a.weight * a.e[k] + b.weight * b.e[k]));
            }
        }
        a = b;
        arc = corner.arc;
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

Moments_2 moments(const Density_2& density, const Coordinates<2>& origin, std::span<const Corner_2> corners) {
    if (const auto* formula = std::get_if<Density>(&density)) return moments(*formula, origin, corners);
    if (corners.size() < 2) return {};
    if (const auto* smooth = std::get_if<Smooth_density>(&density)) return smooth_moments(*smooth, origin, corners);
    if (const auto* placed = std::get_if<Placed_image>(&density)) return placed_moments(*placed, origin, corners);
    return image_moments(std::get<Image_density>(density), origin, corners);
}

}  // namespace annulus::inline v1
