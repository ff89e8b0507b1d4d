// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/motion/moments_sin2.h>

#include <annulus/motion/gauss_legendre.h>
#include <annulus/motion/moments_smooth.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace annulus {

namespace {

/// Two doubles that are worked on at once, as many as any x86-64 does. Always two, so that sums have the same bits whatever the machine.
using Pair [[gnu::vector_size(16)]] = double;

/// sin^2 r, sin 2r and cos 2r.
struct Waves {
    double square, sine, cosine;
};

/// Errors of a few roundings, for sin^2 relative up to those of r; 0 <= r < 1e5. Both series side by side, without a branch that
/// depends on r: a sine and a cosine of the library cost twice as much.
Waves waves(double r) {
    // Less quarter turns; pi / 2 in three parts of 33 bits, so that their products are exact (Cody and Waite).
    const int turns = static_cast<int>(r * (2 * std::numbers::inv_pi) + 0.5);
    const double n = turns;
    const double y = ((r - n * 0x1.921fb544p+0) - n * 0x1.0b4611a6p-34) - n * 0x1.3198a2ep-69, z = y * y;
    // Taylor series, |y| < pi / 4 and a rounding: sin y up to y^17, cos y up to y^16, as products of 1 - z / (2k (2k +
    // 1)) and 1 - z / (2k (2k - 1)) within each other; what is left out is below 3e-18.
    Pair series{1, 1};
    for (int k = 8; k >= 2; --k)
        series = 1 - series * (z * Pair{1.0 / (2 * k * (2 * k + 1)), 1.0 / (2 * k * (2 * k - 1))});
    const double s = y - y * (z * (1.0 / 6)) * series[0], less = z * 0.5 * series[1], c = 1 - less;
    const double squares[2] = {s * s, c * c}, sign = 1 - 2 * (turns & 1);
    return {squares[turns & 1], sign * (2 * s * c), sign * ((c - s) * (c + s))};
}

/// tail<m> v^m bounds what the terms of the density f from f[m] v^m on add to a moment, relative to the area (and to the area times h).
///
/// With r^2 = r_^2 + 2 r_ v and |v| <= y, complex, |Im r| <= y: r^2 keeps within the parabola around the real axis that
/// is the image of |Im r| = y, whose distance from r_^2 is 2 r_ y, or more where y > r_. So |cos 2r| <= cosh 2y there,
/// |f[m]| <= cosh(2y) / (2 y^m) by Cauchy for every y, and y = m / 2 makes it (2 e / m)^m / 4. Later terms add less
/// than a fifth of it where 2 v < m / 6. Over a convex region the mean of |v|^m is at most 2 / (m + 2) of its greatest
/// (a triangle that widens to there), up to v's curvature.
template <std::size_t m>
constexpr double tail = [] {
    double x = 0.6 / (m + 2);
    for (std::size_t i = 0; i < m; ++i) x *= 2 * std::numbers::e / m;
    return x;
}();

/// c = (n!)^4 / ((2n + 1) ((2n)!)^3): Gauss's rule with n nodes has on an edge of length l the remainder c l^(2n + 1) times a derivative of
/// order 2n by arc length.
///
/// Growth, c n: what is integrated are psi v and psi u.du, psi' = the density, whose k-th derivative is at most 2^(k - 1), k > 0; so
/// at most 2n 2^(2n - 3) in first order of h, times the cosine of the edge's angle to the radius to the power 2n - 1. As the edges'
/// extents along the radius add up to 4 h, the sum over all edges is at most c (2 l)^(2n) n h.
///
/// Pole, 2 c (2n)!: 1 / r^2 has poles off the edge at a distance d >= r_ - h, and the terms of the first moments in it are of
/// degree 2n - 2 in l / d: 2 c (2n)! l^2 (l / d)^(2n - 2) h times the density, with the constant as measured, 5 times too large.
struct Remainder {
    double growth, pole;
};
template <int n>
constexpr Remainder remainder = [] {
    double c = 1.0 / (2 * n + 1), p = c;
    for (int i = 1; i <= 2 * n; ++i) {
        const double f = i <= n ? 1.0 * i * i * i * i : 1;
        c *= f / (1.0 * i * i * i), p *= f / (1.0 * i * i);
    }
    return Remainder{c * n, 2 * p};
}();

/// What decides, from the size of a cell.
struct Demand {
    double v, length4;           ///< greatest |v|; 4 edge^2
    double edge2, pole2;         ///< edge^2; (edge / distance from (0, 0))^2
    double density, mass, area;  ///< allowed error of the density and of the mass; 1e-9 of the area

    Demand(double r, const Size_2& size) {
        // |sin r| >= 2 off, and changes by h at most; where it is 0 the mean of its square is that of a squared coordinate, which is
        // h^2 / 8 for a regular triangle, and about h^2 / 64 for cells three times as long as wide. No sine: what is decided here must be
        // known early, because a wrong guess of the processor costs it as much as two edges.
        const double h = size.radius, turns = r * std::numbers::inv_pi,
                     off = std::abs(turns - static_cast<int>(turns + 0.5));
        const double sine = std::max(2 * off - h, h / 8);
        density = 1e-9 * (sine * sine);
        mass = density * size.area;
        area = 1e-9 * size.area;
        v = h * (1 + h / (2 * r));
        edge2 = size.edge * size.edge;
        length4 = 4 * edge2;
        pole2 = edge2 / ((r - h) * (r - h));
    }
};

/// Whether all that is left out is below 1e-9 of the mass.
template <int nodes, std::size_t degree>
bool suffices(const Demand& demand) {
    double v = 1, growth = 1, pole = demand.edge2;
    for (std::size_t k = 0; k <= degree; ++k) v *= demand.v;
    for (int k = 0; k < nodes; ++k) growth *= demand.length4;
    for (int k = 1; k < nodes; ++k) pole *= demand.pole2;
    // One branch and not three.
    return (int(v * tail<degree + 1> <= demand.density) & int(growth * remainder<nodes>.growth <= demand.mass) &
            int(pole * remainder<nodes>.pole <= demand.area)) != 0;
}

/// With v = (r^2 - r_^2) / (2 r_), psi(v) = integral of the density f from 0 to v, p = c + u the position: r_ psi p /
/// r^2 has the divergence f, and r_ psi times the unit matrix, f p. Where the series of f is cut off, this is exact for
/// what is left of it. Along the boundary, with k = cross(c, du), kappa = cross(u, du) and g = psi / (r_ + 2 v):
///
///     mass = sum of g (k + kappa),
///     first moment along c = sum of psi k - r_ g (k + kappa) = sum of (2 k v - r_ kappa) g,
///     first moment across c = sum of -psi c.du = sum of psi u.du, because psi dv sums up to 0 and r_ dv = (c + u).du.
///
/// The last two are written so that nothing of the size of r_ cancels. Two edges at once, one in each lane.
template <int nodes, std::size_t degree>
Moments_2 around(const Coordinates<2>& c, double r, std::span<const Corner_2> corners) {
    // potential[k] = f[k] / (k + 1), f[k] the coefficients of the density. y(z) = cos(2 sqrt(z)) has z y'' + y'/2 + y
    // = 0, which gives (k + 1) (k + 2) y[k + 2] = -(k + 1) (2k + 1) y[k + 1] / r - 4 y[k] in powers of v.
    std::array<double, degree + 1> potential;
    const Waves at = waves(r);
    const double over_r = 1 / r;
    potential[0] = at.square, potential[1] = at.sine / 2;
    double before = at.sine, f = at.cosine - at.sine * (over_r / 2);
#pragma GCC unroll 16
    for (std::size_t k = 2; k <= degree; ++k) {
        const auto m = static_cast<double>(k);
        potential[k] = f * (1 / (m + 1));
        const double next = ((1 - 2 * m) / (m + 1) * over_r) * f + (-4 / (m * (m + 1))) * before;
        before = f, f = next;
    }

    const Gauss_rule& rule = gauss_rule(nodes);
    const std::size_t size = corners.size();
    const double c0 = c[0], c1 = c[1];
    Pair mass{}, along{}, across{};
    for (std::size_t i = 0; i < size; i += 2) {
        const Coordinates<2>&p = corners[i].offset, &q = corners[i + 1 < size ? i + 1 : 0].offset;
        const Coordinates<2>& s = i + 1 >= size ? q : corners[i + 2 < size ? i + 2 : 0].offset;
        const Pair a0{p[0], q[0]}, a1{p[1], q[1]}, b0{q[0], s[0]}, b1{q[1], s[1]};
        const Pair d0 = b0 - a0, d1 = b1 - a1, m0 = 0.5 * (a0 + b0), m1 = 0.5 * (a1 + b1);
        const Pair k = c0 * d1 - c1 * d0, kappa = m0 * d1 - m1 * d0, md = m0 * d0 + m1 * d1, dd = d0 * d0 + d1 * d1;
        const Pair middle = (c0 * m0 + c1 * m1 + 0.5 * (m0 * m0 + m1 * m1)) * over_r;
        const Pair slope = (c0 * d0 + c1 * d1 + md) * over_r, bend = dd * (0.5 * over_r);
        Pair v[nodes], psi[nodes];
        for (std::size_t j = 0; j < nodes / 2; ++j) {
            const double x = 0.5 - rule.node[j];
            const Pair even = middle + (x * x) * bend, odd = x * slope;
            v[j] = even - odd;
            v[nodes - 1 - j] = even + odd;
        }
        for (Pair& value : psi) value = Pair{potential[degree], potential[degree]};
#pragma GCC unroll 16
        for (std::size_t m = 1; m <= degree; ++m)
            for (std::size_t j = 0; j < nodes; ++j) psi[j] = psi[j] * v[j] + potential[degree - m];
        Pair g_sum{}, gv_sum{}, psi_sum{}, odd_sum{};
        for (std::size_t j = 0; j < nodes; ++j) {
            psi[j] *= v[j] * rule.weight[j];
            const Pair g = psi[j] / (r + (v[j] + v[j]));
            g_sum += g;
            gv_sum += g * v[j];
            psi_sum += psi[j];
        }
        for (std::size_t j = 0; j < nodes / 2; ++j) odd_sum += (0.5 - rule.node[j]) * (psi[nodes - 1 - j] - psi[j]);
        mass += (k + kappa) * g_sum;
        along += 2 * k * gv_sum - r * (kappa * g_sum);
        across += md * psi_sum + dd * odd_sum;
    }
    const double a = (along[0] + along[1]) * over_r, b = (across[0] + across[1]) * over_r;
    return {mass[0] + mass[1], {a * c0 - b * c1, a * c1 + b * c0}};
}

}  // namespace

Moments_2 sin2_moments(const Coordinates<2>& origin, std::span<const Corner_2> corners) {
    if (corners.empty()) return {};
    const double r = std::sqrt(origin[0] * origin[0] + origin[1] * origin[1]);
    const Size_2 size = size_of(origin, corners);
    if (!size.arcs && size.radius <= 1.5 && r > 4 * size.radius && r < 1e5) {
        // Two, because most cells of a motion need no more than the first, and few more than the second.
        const Demand demand(r, size);
        if (suffices<4, 7>(demand)) return around<4, 7>(origin, r, corners);
        if (suffices<8, 13>(demand)) return around<8, 13>(origin, r, corners);
    }
    const auto at = [](const Coordinates<2>& p) {
        const double distance = std::sqrt(p[0] * p[0] + p[1] * p[1]);
        return distance < 1e5 ? waves(distance).square : density_at(Density::sin2, p);
    };
    static const Smooth_density sin2{at, 1, 0.5, 2};
    return smooth_moments(sin2, origin, corners);
}

}  // namespace annulus
