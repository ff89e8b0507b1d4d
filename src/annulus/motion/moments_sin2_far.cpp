// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/motion/moments_sin2_far.h>

#include <annulus/motion/boundary_nodes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace annulus {

namespace {

constexpr std::size_t max_degree = 31;

/// Two doubles that are worked on at once, as many as any x86-64 does. Always two, so that sums have the same bits
/// whatever the machine.
using Pair [[gnu::vector_size(16)]] = double;

/// sin^2 r, sin 2r and cos 2r.
struct Waves {
    double square, sine, cosine;
};

/// Errors of a few roundings, for sin^2 relative up to those of r; r >= 0. Both series side by side, without a branch
/// that depends on r: a sine and a cosine of the library cost twice as much.
Waves waves(double r) {
    if (!(r < 1e5)) {
        const double s = std::sin(r), c = std::cos(r);
        return {s * s, 2 * s * c, (c - s) * (c + s)};
    }
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

/// at(1), at(2), ...
constexpr auto table(auto at) {
    std::array<double, max_degree + 3> of{};
    for (std::size_t k = 1; k < of.size(); ++k) of[k] = at(static_cast<double>(k));
    return of;
}
constexpr auto inverse = table([](double k) { return 1 / k; });
// What f[k] / r and f[k - 1] count in f[k + 1]: see Far_cell::expand.
constexpr auto linear = table([](double k) { return -2 * (k - 0.5) / (k + 1); });
constexpr auto constant = table([](double k) { return -4 / (k * (k + 1)); });
/// tail[m] v^m bounds what terms from f[m] v^m on add to a moment, relative to the area (and to the area times h).
///
/// With r^2 = r_^2 + 2 r_ v and |v| <= y, complex, |Im r| <= y: r^2 keeps within the parabola around the real axis that
/// is the image of |Im r| = y, whose distance from r_^2 is 2 r_ y, or more where y > r_. So |cos 2r| <= cosh 2y there,
/// |f[m]| <= cosh(2y) / (2 y^m) by Cauchy for every y, and y = m / 2 makes it (2 e / m)^m / 4. Later terms add less
/// than a fifth of it where 2 v < m / 6. Over a convex region the mean of |v|^m is at most 2 / (m + 2) of its greatest
/// (a triangle that widens to there), up to v's curvature.
constexpr auto tail = table([](double m) {
    double x = 0.6 / (m + 2);
    for (int i = 0; i < static_cast<int>(m); ++i) x *= 2 * std::numbers::e / m;
    return x;
});

/// What is enough for a cell.
struct Effort {
    int nodes;
    std::size_t degree;         ///< of the density
    double tail, growth, pole;  ///< limits: see suffices
};

/// What decides, from the size of a cell.
struct Demand {
    double v, length4;           ///< greatest |v|; 4 edge^2
    double edge2, pole2;         ///< edge^2; (edge / distance from (0, 0))^2
    double density, mass, area;  ///< allowed error of the density and of the mass; 1e-13 of the area

    Demand(double r, const Size_2& size) {
        const double h = size.radius, turns = r * std::numbers::inv_pi,
                     off = r < 1e5 ? std::abs(turns - static_cast<int>(turns + 0.5)) : 0;
        // |sin r| >= 2 off, and changes by h at most; where it is 0 the mean of its square is that of a squared
        // coordinate, which is h^2 / 8 for a regular triangle, and about h^2 / 64 for cells three times as long as
        // wide. No sine: what is decided here must be known early, because a wrong guess of the processor costs it as
        // much as two edges.
        const double sine = std::max(2 * off - h, h / 8), close = r - h;
        density = 1e-13 * (sine * sine);
        mass = density * size.area;
        area = 1e-13 * size.area;
        v = h * (1 + h / (2 * r));
        edge2 = size.edge2;
        length4 = 4 * edge2;
        pole2 = edge2 / (close * close);
    }
};

/// For Gauss's rule with n nodes the remainder on an edge of length l is c l^(2n + 1) times a derivative of order 2n by
/// arc length, c = (n!)^4 / ((2n + 1) ((2n)!)^3).
///
/// Growth: what is integrated are psi v and psi u.du, psi' = the density, whose k-th derivative is at most 2^(k - 1), k
/// > 0; so at most 2n 2^(2n - 3) in first order of h, times the cosine of the edge's angle to the radius to the power
/// 2n - 1. As the edges' extents along the radius add up to 4 h, the sum over all edges is at most c (2 l)^(2n) n h.
///
/// Pole: 1 / r^2 has poles off the edge at a distance d >= r_ - h, and the terms of the first moments in it are of
/// degree 2n - 2 in l / d: 2 c (2n)! l^2 (l / d)^(2n - 2) h times the density, with the constant as measured, 5 times
/// too large.
constexpr Effort effort(int n, std::size_t degree) {
    double c = 1.0 / (2 * n + 1), p = c;  // (n!)^4 / ((2n + 1) ((2n)!)^3), and (2n)! times that
    for (int i = 1; i <= 2 * n; ++i) {
        const double f = i <= n ? 1.0 * i * i * i * i : 1;
        c *= f / (1.0 * i * i * i), p *= f / (1.0 * i * i);
    }
    return {n, degree, tail[degree + 1], c * n, 2 * p};
}

bool suffices(const Effort& e, const Demand& demand) {
    double v = demand.v, growth = 1, pole = demand.edge2;
    for (std::size_t k = 0; k < e.degree; ++k) v *= demand.v;
    for (int k = 0; k < e.nodes; ++k) growth *= demand.length4;
    for (int k = 1; k < e.nodes; ++k) pole *= demand.pole2;
    // One branch and not three.
    return (int(v * e.tail <= demand.density) & int(growth * e.growth <= demand.mass) &
            int(pole * e.pole <= demand.area)) != 0;
}

// Few, because cells of one motion that want different ones cost a wrong guess each.
constexpr Effort small = effort(5, 9), medium = effort(7, 13), large = effort(11, max_degree);

/// With v = (r^2 - r_^2) / (2 r_), psi(v) = integral of the density f from 0 to v, p = c + u the position: r_ psi p /
/// r^2 has the divergence f, and r_ psi times the unit matrix, f p. Where the series of f is cut off, this is exact for
/// what is left of it. Along the boundary, with k = cross(c, du), kappa = cross(u, du) and g = psi / (r_ + 2 v):
///
///     mass = sum of g (k + kappa),
///     first moment along c = sum of psi k - r_ g (k + kappa) = sum of (2 k v - r_ kappa) g,
///     first moment across c = sum of -psi c.du = sum of psi u.du, because psi dv sums up to 0 and r_ dv = (c + u).du.
///
/// The last two are written so that nothing of the size of r_ cancels.
class Far_cell {
  public:
    Far_cell(const Coordinates<2>& c, double r) : c_(c), r_(r), over_r_(1 / r) {}

    Moments_2 moments(std::span<const Corner_2> corners, const Size_2& size) {
        const Demand demand(r_, size);
        if (suffices(small, demand)) run<small.nodes>(small.degree, corners);
        else if (suffices(medium, demand)) run<medium.nodes>(medium.degree, corners);
        else run<large.nodes>(large.degree, corners);
        if (size.arcs) add_arcs(corners);
        const double mass = mass_[0] + mass_[1], along = (along_[0] + along_[1]) * over_r_,
                     across = (across_[0] + across_[1]) * over_r_;
        return {mass, {along * c_[0] - across * c_[1], along * c_[1] + across * c_[0]}};
    }

    /// A node of an arc.
    void operator()(const Coordinates<2>& u, const Coordinates<2>& d) {
        const double v = (c_[0] * u[0] + c_[1] * u[1] + (u[0] * u[0] + u[1] * u[1]) / 2) * over_r_;
        double psi = potential_[degree_][0];
        for (std::size_t k = degree_; k-- > 0;) psi = psi * v + potential_[k][0];
        psi *= v;
        const double g = psi / (r_ + 2 * v), k = c_[0] * d[1] - c_[1] * d[0], kappa = u[0] * d[1] - u[1] * d[0];
        mass_[0] += (k + kappa) * g;
        along_[0] += (2 * k * v - r_ * kappa) * g;
        across_[0] += psi * (u[0] * d[0] + u[1] * d[1]);
    }

  private:
    /// potential_[k] = f[k] / (k + 1), f[k] the coefficients of the density. y(z) = cos(2 sqrt(z)) has z y'' + y'/2 + y
    /// = 0, which gives (k + 1) (k + 2) y[k + 2] = -(k + 1) (2k + 1) y[k + 1] / r_ - 4 y[k] in powers of v. A rounding
    /// grows like (2 / r_)^k, and counts v^k < (r_ / 3)^k.
    void expand(std::size_t degree) {
        const Waves at = waves(r_);
        const double f0 = at.square, f1 = at.sine, f2 = at.cosine - f1 * (over_r_ / 2);
        potential_[0] = Pair{f0, f0};
        potential_[1] = Pair{f1 / 2, f1 / 2};
        double before = f1, f = f2;
        for (std::size_t k = 2; k <= degree; ++k) {
            const double p = f * inverse[k + 1];
            potential_[k] = Pair{p, p};
            const double next = (linear[k] * over_r_) * f + constant[k] * before;
            before = f;
            f = next;
        }
        degree_ = degree;
    }

    template <int n>
    void run(std::size_t degree, std::span<const Corner_2> corners) {
        expand(degree);
        straight<n>(corners);
    }

    [[gnu::noinline]] void add_arcs(std::span<const Corner_2> corners) {
        for (std::size_t i = 0; i < corners.size(); ++i)
            if (corners[i].arc)
                arc_nodes(c_, corners[i].offset, corners[i + 1 < corners.size() ? i + 1 : 0].offset, *this);
    }

    /// Two edges at once, one in each lane.
    template <int n>
    void straight(std::span<const Corner_2> corners) {
        const Gauss_rule& rule = gauss_rule(n);
        const std::size_t size = corners.size(), degree = degree_;
        const double c0 = c_[0], c1 = c_[1], r = r_, over_r = over_r_;
        Pair mass{}, along{}, across{};
        for (std::size_t i = 0; i < size; i += 2) {
            const Corner_2 &p = corners[i], &q = corners[i + 1 < size ? i + 1 : 0];
            const Corner_2& s = i + 1 >= size ? q : corners[i + 2 < size ? i + 2 : 0];
            const Pair a0{p.offset[0], q.offset[0]}, a1{p.offset[1], q.offset[1]};
            const Pair b0{q.offset[0], s.offset[0]}, b1{q.offset[1], s.offset[1]};
            Pair d0 = b0 - a0, d1 = b1 - a1;
            if (p.arc || q.arc) {  // arcs: no length here
                const Pair some{p.arc ? 0.0 : 1.0, q.arc ? 0.0 : 1.0};
                d0 *= some, d1 *= some;
            }
            const Pair m0 = 0.5 * (a0 + b0), m1 = 0.5 * (a1 + b1);
            const Pair k = c0 * d1 - c1 * d0, kappa = m0 * d1 - m1 * d0, md = m0 * d0 + m1 * d1, dd = d0 * d0 + d1 * d1;
            const Pair middle = (c0 * m0 + c1 * m1 + 0.5 * (m0 * m0 + m1 * m1)) * over_r;
            const Pair slope = (c0 * d0 + c1 * d1 + md) * over_r, bend = dd * (0.5 * over_r);
            Pair v[n], psi[n];
            for (int j = 0; j < n / 2; ++j) {
                const double x = 0.5 - rule.node[static_cast<std::size_t>(j)];
                const Pair even = middle + (x * x) * bend, odd = x * slope;
                v[j] = even - odd;
                v[n - 1 - j] = even + odd;
            }
            if (n % 2) v[n / 2] = middle;
            const Pair* at = potential_.data() + degree;
            for (int j = 0; j < n; ++j) psi[j] = *at;
            while (at != potential_.data()) {
                const Pair next = *--at;
                for (int j = 0; j < n; ++j) psi[j] = psi[j] * v[j] + next;
            }
            Pair g_sum{}, gv_sum{}, psi_sum{}, odd_sum{};
            for (int j = 0; j < n; ++j) {
                psi[j] *= v[j] * rule.weight[static_cast<std::size_t>(j)];
                const Pair g = psi[j] / (r + (v[j] + v[j]));
                g_sum += g;
                gv_sum += g * v[j];
                psi_sum += psi[j];
            }
            for (int j = 0; j < n / 2; ++j)
                odd_sum += (0.5 - rule.node[static_cast<std::size_t>(j)]) * (psi[n - 1 - j] - psi[j]);
            mass += (k + kappa) * g_sum;
            along += 2 * k * gv_sum - r * (kappa * g_sum);
            across += md * psi_sum + dd * odd_sum;
        }
        mass_ = mass, along_ = along, across_ = across;
    }

    Coordinates<2> c_;
    double r_, over_r_;
    std::size_t degree_;
    std::array<Pair, max_degree + 1> potential_;
    Pair mass_{}, along_{}, across_{};
};

}  // namespace

Moments_2 far_sin2_moments(const Coordinates<2>& origin, double r, std::span<const Corner_2> corners,
                           const Size_2& size) {
    return Far_cell(origin, r).moments(corners, size);
}

}  // namespace annulus
