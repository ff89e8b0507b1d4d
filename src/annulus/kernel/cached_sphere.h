// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/bounds.h>
#include <annulus/space/euclidean.h>
#include <annulus/types.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace annulus::inline v1 {

/// The circumsphere of a cell, stored with it. A point is then tested by d multiplications with stored values, without
/// a determinant of the cell. 2D and 3D share the formula.
///
/// With the corners relative to one of them, p, and |b|^2 appended, the empty-sphere determinant of a point q is
///   value(q) = |q - p|^2 D - (q - p) . N,
/// where D is the determinant of the corners (twice the area, six times the volume) and N their generalised cross
/// product weighted by the squares. It is negative when q is inside, for a positive cell. For an infinite cell the
/// corner at infinity is taken as b = 0 with |b|^2 = m^2. Then D is 0 and N the outward normal of the finite facet:
/// the value is negative when q is beyond the facet, and no branch distinguishes the two kinds of cells.
///
/// N and D are divided by t^d, where t is the power of two above the largest coordinate m of the corners, so that
/// bounds and values of large and small cells are similar. Error, for R = |q - p| and coordinates of q - p up to r <=
/// R: that of the two terms is at most s u m^d r^2 and l u m^(d+1) r (bounds::cached_sphere_d_square, _linear;
/// proofs/gappa/cached_sphere_d.g), and that of their difference u times their sum, at most a m^d r^2 + b m^(d+1) r (a
/// = 4, b = 8 in 2D, 18 and 54 in 3D: the largest values of the terms). With 2 r m <= r^2 + m^2 and m < t the total is
/// at most unit (R^2 + t^2) for a unit of s + a + (l + b) / 2 times u. The unit used is larger: the rest covers the
/// rounding of R^2 and of the bound itself. This holds for t between 2^-200 and 2^60; `bound` is infinite outside, and
/// at least 2^-120, which covers underflow. Round to nearest.
template <int d>
struct Cached_sphere {
    static constexpr double units = d == 3 ? 1024 : 128;
    static constexpr double unit = units * bounds::u;
    static constexpr float least_bound = 0x1p-120F;
    static_assert(d == 2 ? (bounds::cached_sphere_2_square + 5) + (bounds::cached_sphere_2_linear + 9) / 2 < 0.9 * units
                         : (bounds::cached_sphere_3_square + 19) + (bounds::cached_sphere_3_linear + 55) / 2 <
                               0.9 * units);

    std::array<double, static_cast<std::size_t>(d)> normal;
    double determinant;

    /// The value at a point and its error bound: the sign is right where the value is above the bound in magnitude.
    struct Value {
        double value;
        double bound;
        [[nodiscard]] bool inside() const { return value < -bound; }
        [[nodiscard]] bool certain() const { return std::fabs(value) > bound; }
    };
    /// `from` is q - p, `constant` the bound of the cell.
    [[nodiscard]] Value at(const std::array<double, static_cast<std::size_t>(d)>& from, float constant) const {
        double square = from[0] * from[0], along = from[0] * normal[0];
        for (std::size_t c = 1; c < d; ++c) {
            square += from[c] * from[c];
            along += from[c] * normal[c];
        }
        return {square * determinant - along, unit * square + static_cast<double>(constant)};
    }
};

/// A corner relative to p, with its square; for infinity zeros, and -1 until m is known.
template <int d>
struct Lifted {
    std::array<double, static_cast<std::size_t>(d)> from{};
    double square = -1;

    Lifted() = default;
    Lifted(const Coordinates<d>& b, const Coordinates<d>& p) : from(Euclidean<d>::difference(b, p)), square(0) {
        for (const double x : from) square += x * x;
    }
    [[nodiscard]] double magnitude() const {
        double m = 0;
        for (const double x : from) m = std::max(m, std::fabs(x));
        return m;
    }
};

namespace detail {

struct Power {
    double inverse;  ///< 1 / t
    float bound;
};
/// t is the power of two just above m.
template <int d>
[[nodiscard]] inline Power power_above(double m) {
    constexpr std::uint64_t exponent_bits = 0x7ff0000000000000ULL, one = 0x0010000000000000ULL;
    const std::uint64_t t = (std::bit_cast<std::uint64_t>(m) & exponent_bits) + one;
    const double power = std::bit_cast<double>(t), inverse = std::bit_cast<double>((2046ULL << 52) - t);
    if (!(m >= 0x1p-200 && m <= 0x1p60)) [[unlikely]]
        return {1.0, std::numeric_limits<float>::infinity()};
    return {inverse,
            std::max(static_cast<float>(Cached_sphere<d>::unit * (power * power)), Cached_sphere<d>::least_bound)};
}

}  // namespace detail

/// The sphere of a positive cell p, a, b (, c), where one corner other than p may be infinity. `bound` receives its
/// constant.
[[nodiscard]] inline Cached_sphere<2> cached_sphere(Lifted<2> a, Lifted<2> b, float& bound) {
    const double m = std::max(a.magnitude(), b.magnitude());
    if (a.square < 0) a.square = m * m;
    if (b.square < 0) b.square = m * m;
    const detail::Power t = detail::power_above<2>(m);
    bound = t.bound;
    const double scale = t.inverse * t.inverse;
    return {
        {(a.square * b.from[1] - b.square * a.from[1]) * scale, (b.square * a.from[0] - a.square * b.from[0]) * scale},
        (a.from[0] * b.from[1] - a.from[1] * b.from[0]) * scale};
}
[[nodiscard]] inline Cached_sphere<3> cached_sphere(Lifted<3> a, Lifted<3> b, Lifted<3> c, float& bound) {
    const double m = std::max(a.magnitude(), std::max(b.magnitude(), c.magnitude()));
    if (a.square < 0) a.square = m * m;
    if (b.square < 0) b.square = m * m;
    if (c.square < 0) c.square = m * m;
    const detail::Power t = detail::power_above<3>(m);
    bound = t.bound;
    const double scale = t.inverse * t.inverse * t.inverse;
    const auto cross = [](const Lifted<3>& l, const Lifted<3>& r) {
        return std::array{l.from[1] * r.from[2] - l.from[2] * r.from[1], l.from[2] * r.from[0] - l.from[0] * r.from[2],
                          l.from[0] * r.from[1] - l.from[1] * r.from[0]};
    };
    const auto bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    Cached_sphere<3> s;
    for (std::size_t k = 0; k < 3; ++k)
        s.normal[k] = ((a.square * bc[k] + b.square * ca[k]) + c.square * ab[k]) * scale;
    s.determinant = ((a.from[0] * bc[0] + a.from[1] * bc[1]) + a.from[2] * bc[2]) * scale;
    return s;
}

}  // namespace annulus::inline v1
