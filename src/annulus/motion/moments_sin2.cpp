// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/motion/moments_sin2.h>

#include <annulus/motion/boundary_nodes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numbers>

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

/// Nodes for a straight edge of this length whose line may pass as close as `clearance` to (0, 0), kind "far".
///
/// Two limits. Growth: len^(2n) / (2^(2n-1) (2n)!) <= 1e-16 len^2, solved for len (at len = 3, the longest there is,
/// 10 nodes still have 3e-16 len^2). Poles: 1 / r^2 has them at
/// |t| = y = clearance / (len / 2) on the imaginary axis when the edge is [-1, 1], and the remainder falls like
/// (y + sqrt(1 + y^2))^(-2n); n = 7.5 / log10(1.6 y), solved for y, keeps it below 1e-15.
///
/// One node more than that, because around a zero of the density the leading terms of the first moment are two
/// degrees higher than the bound counts with: without it, cells of 0.001 there are wrong by 4e-11.
int nodes_for(double length, double clearance) {
    static constexpr std::array<double, 10> longest{0, 0, 0, 1.2e-3, 0.028, 0.144, 0.398, 0.80, 1.35, 2.01};
    static constexpr std::array<double, 12> nearest{1e9, 1e9, 1e9, 198, 46.9, 19.8, 11.1, 7.4, 5.4, 4.3, 3.5, 3.0};
    std::size_t n = 3;
    while (n < longest.size() && length > longest[n]) ++n;
    while (n < nearest.size() && 2 * clearance < nearest[n] * length) ++n;
    return static_cast<int>(n) + 1;
}

/// The kind "far". Coefficients once a cell; nodes are gathered and evaluated in blocks of a fixed size,
/// which compilers unroll and vectorise.
class Far_cell {
  public:
    Far_cell(const Coordinates<2>& c, double radius) : c_(c), r_(norm(c)) {
        // density(r_ + t) = sum of rho[k] t^k, rho[k] = -(2^k / k!) cos(2 r_ + k pi/2) / 2 for k > 0.
        const double s = std::sin(r_), co = std::cos(r_), sin2 = 2 * s * co, cos2 = (co - s) * (co + s);
        const std::array<double, 4> cycle{-cos2 / 2, sin2 / 2, cos2 / 2, -sin2 / 2};
        double rho_before = 0, rho = s * s, factor = 1, size = 1;
        const double enough = 1e-17 * radius * radius;
        for (int k = 0; k <= max_degree; ++k) {
            const double a = r_ * rho + rho_before;  // of density times (r_ + t)
            const auto at = static_cast<std::size_t>(k);
            mass_[at] = a * inverse[at + 1];
            first_[at] = a * inverse[at + 2];
            degree_ = at;
            if (k > 1 && size <= enough) break;
            factor *= 2 * inverse[at + 1];
            size *= 2 * radius * inverse[at + 1];
            rho_before = rho;
            rho = factor * cycle[static_cast<std::size_t>((k + 1) % 4)];
        }
    }

    /// A node of an arc.
    void operator()(const Coordinates<2>& u, const Coordinates<2>& d) {
        add(u[0], u[1], (c_[0] + u[0]) * d[1] - (c_[1] + u[1]) * d[0]);
    }

    /// A straight edge. cross(c + u, e) is the same all along it.
    void edge(const Coordinates<2>& a, const Coordinates<2>& b, const Gauss_rule& rule) {
        const double x = b[0] - a[0], y = b[1] - a[1], turn = (c_[0] + a[0]) * y - (c_[1] + a[1]) * x;
        for (std::size_t j = 0; j < static_cast<std::size_t>(rule.size); ++j)
            add(a[0] + rule.node[j] * x, a[1] + rule.node[j] * y, rule.weight[j] * turn);
    }

    Moments_2 result() {
        // Fill up with nodes that weigh nothing.
        while (count_ != 0) add(0, 0, 0);
        return {sum(mass_sum_), {sum(first_sum_[0]), sum(first_sum_[1])}};
    }

  private:
    static constexpr int max_degree = 31;
    static constexpr auto inverse = [] {
        std::array<double, max_degree + 3> of{};
        for (std::size_t k = 1; k < of.size(); ++k) of[k] = 1.0 / static_cast<double>(k);
        return of;
    }();
    static constexpr std::size_t block = 8;
    /// Two doubles that are worked on at once, as many as any x86-64 does; a block is four of them. Always two, so that sums have the
    /// same bits whatever the machine.
    using Pair [[gnu::vector_size(16)]] = double;
    static constexpr std::size_t pairs = block / 2;
    using Block = std::array<Pair, pairs>;

    static double sum(const Pair& x) { return x[0] + x[1]; }

    void add(double u0, double u1, double turn) {
        u0_[count_] = u0, u1_[count_] = u1, turn_[count_] = turn;
        if (++count_ == block) flush();
    }

    /// With r = |c + u|, delta = r - r_, A = integral of density t dt and B = of density t (t - r_) dt from r_ to r:
    /// mass += A dtheta; first += ((c + u) / r B + (r_ (c + u) / r - c) A) dtheta, where
    /// r_ (c + u) - r c = r_ u - delta c.
    void flush() {
        Block u0, u1, turn, delta, q, a, b;
        std::memcpy(u0.data(), u0_.data(), sizeof u0);
        std::memcpy(u1.data(), u1_.data(), sizeof u1);
        std::memcpy(turn.data(), turn_.data(), sizeof turn);
        for (std::size_t j = 0; j < pairs; ++j) {
            const Pair w = (2 * c_[0] + u0[j]) * u0[j] + (2 * c_[1] + u1[j]) * u1[j];  // r^2 - r_^2
            const Pair square = r_ * r_ + w;
            const Pair r{std::sqrt(square[0]), std::sqrt(square[1])};
            const Pair both = 1 / (r * (r + r_));
            delta[j] = w * (both * r);
            q[j] = both * (r + r_);
        }
        potentials(delta, a, b);
        for (std::size_t j = 0; j < pairs; ++j) {
            const Pair t = turn[j] * (q[j] * q[j]);
            const Pair dmass = a[j] * delta[j] * t, dfirst = b[j] * (delta[j] * delta[j]) * t;
            mass_sum_ += dmass;
            first_sum_[0] += q[j] * ((c_[0] + u0[j]) * dfirst + (r_ * u0[j] - delta[j] * c_[0]) * dmass);
            first_sum_[1] += q[j] * ((c_[1] + u1[j]) * dfirst + (r_ * u1[j] - delta[j] * c_[1]) * dmass);
        }
        count_ = 0;
    }

    /// Horner's rule for both potentials (without their factors delta and delta^2) at all nodes of a block.
    void potentials(const Block& x, Block& a, Block& b) const {
        const Pair zero{0, 0};
        Pair a0 = zero + mass_[degree_], a1 = a0, a2 = a0, a3 = a0;
        Pair b0 = zero + first_[degree_], b1 = b0, b2 = b0, b3 = b0;
        for (std::size_t k = degree_; k-- > 0;) {
            const Pair m = zero + mass_[k], f = zero + first_[k];
            a0 = a0 * x[0] + m, a1 = a1 * x[1] + m, a2 = a2 * x[2] + m, a3 = a3 * x[3] + m;
            b0 = b0 * x[0] + f, b1 = b1 * x[1] + f, b2 = b2 * x[2] + f, b3 = b3 * x[3] + f;
        }
        a = {a0, a1, a2, a3};
        b = {b0, b1, b2, b3};
    }

    Coordinates<2> c_;
    double r_;
    std::size_t degree_ = 0, count_ = 0;
    std::array<double, max_degree + 1> mass_, first_;
    std::array<double, block> u0_, u1_, turn_;
    Pair mass_sum_{};
    std::array<Pair, 2> first_sum_{};
};

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

/// Runs `node` around the boundary; `rule_of(length)` gives rule and pieces of a straight edge.
template <class Node, class Rule_of>
void around(const Coordinates<2>& c, std::span<const Corner_2> corners, Node& node, Rule_of&& rule_of) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Coordinates<2>& a = corners[i].offset;
        const Coordinates<2>& b = corners[i + 1 < corners.size() ? i + 1 : 0].offset;
        if (corners[i].arc) {
            arc_nodes(c, a, b, node);
        } else {
            const auto rule = rule_of(norm({b[0] - a[0], b[1] - a[1]}));
            const Gauss_rule& nodes = gauss_rule(rule.nodes);
            if constexpr (requires { node.edge(a, b, nodes); }) node.edge(a, b, nodes);
            else edge_nodes(a, b, nodes, rule.pieces, node);
        }
    }
}

/// No less than the greatest distance of the region from its origin.
double radius_of(const Coordinates<2>& c, std::span<const Corner_2> corners) {
    double square = 0, bulge = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Coordinates<2>& a = corners[i].offset;
        square = std::max(square, a[0] * a[0] + a[1] * a[1]);
        if (!corners[i].arc) continue;
        const double span = arc_span(c, a, corners[i + 1 < corners.size() ? i + 1 : 0].offset);
        const double r = norm({c[0] + a[0], c[1] + a[1]});
        bulge = std::max(bulge, span < 1 ? r * span * span / 8 : 2 * r);  // sagitta
    }
    return std::sqrt(square) + bulge;
}

struct Edge_rule {
    int nodes, pieces;
};

}  // namespace

Moments_2 sin2_moments(const Coordinates<2>& origin, std::span<const Corner_2> corners) {
    const double radius = radius_of(origin, corners), r = norm(origin);
    if (radius <= 1.5 && r > 4 * radius) {
        Far_cell far(origin, radius);
        around(origin, corners, far, [&](double length) { return Edge_rule{nodes_for(length, r - radius), 1}; });
        return far.result();
    }
    if (radius > 1) {
        Moments_2 half = moments(Density::one, origin, corners);
        From_centre<Radial_means (*)(double)> oscillating{origin, cos2_means};
        // 10 nodes on at most 2 units of length: remainder 8e-19. A million pieces at most: see `moments`.
        around(origin, corners, oscillating, [](double length) {
            return Edge_rule{10, 1 + static_cast<int>(std::min(length / 2, 1e6))};
        });
        return {(half.mass - oscillating.sum.mass) / 2,
                {(half.first[0] - oscillating.sum.first[0]) / 2, (half.first[1] - oscillating.sum.first[1]) / 2}};
    }
    From_centre<Radial_means (*)(double)> near{origin, sin2_means};
    around(origin, corners, near, [](double) { return Edge_rule{10, 1}; });
    return near.sum;
}

}  // namespace annulus
