// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/motion/moments_smooth.h>

#include <annulus/motion/boundary_nodes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace annulus {

namespace {

constexpr double promise = 1e-9;
constexpr int least_nodes = 2, most_nodes = 6, arc_nodes_in_pieces = 12;
constexpr double longest = 2;  ///< rate times the length of a piece

double norm(const Coordinates<2>& p) { return std::sqrt(p[0] * p[0] + p[1] * p[1]); }

double power(double x, int n) {
    double product = 1;
    for (int i = 0; i < n; ++i) product *= x;
    return product;
}

/// The bound of the error with n nodes, relative to amplitude * area.
double remainder(int n, double x, double y) {
    double ray = 1.0 / (n + 1), edge = 1.0 / (2 * n + 1);  // R_n and S_n
    for (int i = 1; i <= 2 * n; ++i) {
        const double up = i <= n ? i * (i + 1.0) : 1, f = i <= n ? power(i, 4) : 1;
        ray *= up * up / (power(i + 1, 2) * i);
        edge *= f / power(i, 3);
    }
    return ray * power(x, 2 * n - 1) * (x + 2 * n) + edge * power(y, 2 * n) * (1 + 2 * n / x);
}

class Cones {
  public:
    Cones(const Smooth_density& density, const Coordinates<2>& c, std::span<const Corner_2> corners)
        : density_(density), c_(c), corners_(corners), size_(size_of(c, corners)) {}

    Moments_2 moments() {
        const double x = density_.rate * size_.radius, y = density_.rate * size_.edge;
        // The first, of few nodes, says how large the mass is, and so how many are needed.
        for (int n = x <= longest && y <= longest ? least_nodes : most_nodes + 1; n <= most_nodes; ++n) {
            const double error = remainder(n, x, y) * density_.amplitude;
            if (n > least_nodes && error * area_ > promise * sum_.mass) continue;
            add(1, n, radial_rule(n), false);
            if (error * area_ <= promise * sum_.mass) return sum_;
        }
        add(1 + static_cast<int>(x / longest), most_nodes, gauss_rule(most_nodes), true);
        return sum_;
    }

  private:
    /// Starts again, with `nodes` on edges or pieces of them and `pieces` of rays, each with `rule`; `lengths` tells that it is a rule for t f.
    void add(int pieces, int nodes, const Gauss_rule& rule, bool lengths) {
        sum_ = {};
        area_ = 0;
        const double q = density_.rate;
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const Coordinates<2>&a = corners_[i].offset, &b = corners_[i + 1 < corners_.size() ? i + 1 : 0].offset;
            const auto ray = [&](const auto& u, const auto& d) { add_ray(u, d, pieces, rule, lengths); };
            if (corners_[i].arc) {
                const double r = norm({c_[0] + a[0], c_[1] + a[1]});
                arc_nodes(c_, a, b, ray, gauss_rule(lengths ? arc_nodes_in_pieces : nodes + 1), 2 * longest / (q * r));
            } else {
                const double length = lengths ? q * norm({b[0] - a[0], b[1] - a[1]}) : 0;
                edge_nodes(a, b, gauss_rule(nodes), 1 + static_cast<int>(length / longest), ray);
            }
        }
    }

    /// A ray to u, of a boundary along d.
    void add_ray(const Coordinates<2>& u, const Coordinates<2>& d, int pieces, const Gauss_rule& rule, bool lengths) {
        const double part = 1.0 / pieces, share = u[0] * d[1] - u[1] * d[0];
        double zeroth = 0, first = 0;
        for (int piece = 0; piece < pieces; ++piece)
            for (std::size_t k = 0; k < static_cast<std::size_t>(rule.size); ++k) {
                const double t = (piece + rule.node[k]) * part, w = rule.weight[k] * part * (lengths ? t : 1);
                const double f = w * density_.at({c_[0] + t * u[0], c_[1] + t * u[1]});
                zeroth += f;
                first += t * f;
            }
        area_ += share / 2;
        sum_.mass += share * zeroth;
        for (std::size_t k = 0; k < 2; ++k) sum_.first[k] += share * first * u[k];
    }

    const Smooth_density& density_;
    const Coordinates<2> c_;
    std::span<const Corner_2> corners_;
    Size_2 size_;
    Moments_2 sum_;
    double area_ = 0;
};

}  // namespace

Size_2 size_of(const Coordinates<2>& c, std::span<const Corner_2> corners) {
    double square = 0, edge2 = 0, bulge = 0, twice = 0;
    bool arcs = false;
    const Corner_2* before = &corners.back();
    for (const Corner_2& corner : corners) {
        const Coordinates<2>&a = before->offset, &b = corner.offset;
        const double x = b[0] - a[0], y = b[1] - a[1];
        square = std::max(square, b[0] * b[0] + b[1] * b[1]);
        edge2 = std::max(edge2, x * x + y * y);
        twice += a[0] * b[1] - a[1] * b[0];
        arcs = arcs || corner.arc;
        if (before->arc) {
            const double span = arc_span(c, a, b), r = norm({c[0] + a[0], c[1] + a[1]});
            bulge = std::max(bulge, span < 1 ? r * span * span / 8 : 2 * r);  // sagitta
        }
        before = &corner;
    }
    return {std::sqrt(square) + bulge, std::sqrt(edge2), twice / 2, arcs};
}

Moments_2 smooth_moments(const Smooth_density& density, const Coordinates<2>& origin,
                         std::span<const Corner_2> corners) {
    if (corners.empty()) return {};
    return Cones(density, origin, corners).moments();
}

}  // namespace annulus
