// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/moments_smooth.h>

#include <annulus/predicate/lanes.h>
#include <apps/motion/boundary_nodes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace annulus::inline v1 {

namespace {

constexpr double promise = 1e-9;
constexpr int least_nodes = 2, most_nodes = 6, arc_nodes_in_pieces = 12;
constexpr double longest = 2;  ///< rate times the length of a piece

double norm(const Coordinates<2>& p) { return std::sqrt(p[0] * p[0] + p[1] * p[1]); }

/// R_n and S_n.
struct Remainder {
    double ray, edge;
};
constexpr std::array<Remainder, most_nodes + 1> remainders = [] {
    std::array<Remainder, most_nodes + 1> out{};
    for (int n = 1; n <= most_nodes; ++n) {
        double ray = 1.0 / (n + 1), edge = 1.0 / (2 * n + 1);
        for (double i = 1; i <= 2 * n; ++i) {
            ray *= (i <= n ? i * (i + 1) * (i * (i + 1)) : 1) / ((i + 1) * (i + 1) * i);
            edge *= (i <= n ? i * i * i * i : 1) / (i * i * i);
        }
        out[static_cast<std::size_t>(n)] = {ray, edge};
    }
    return out;
}();

/// Bounds of the error with n nodes, relative to the area: errors[n].
std::array<double, most_nodes + 1> errors_of(double amplitude, double x, double y) {
    std::array<double, most_nodes + 1> out{};
    double ray = x, edge = y * y;  // x^(2n - 1), y^2n
    for (std::size_t n = 1; n < out.size(); ++n) {
        const auto twice = static_cast<double>(2 * n);
        out[n] = amplitude * (remainders[n].ray * ray * (x + twice) + remainders[n].edge * edge * (1 + twice / x));
        ray *= x * x;
        edge *= y * y;
    }
    return out;
}

/// `Density` has amplitude, rate, and values(x, y, f, n), which writes its values at n positions.
template <class Density>
class Cones {
  public:
    Cones(const Density& density, const Coordinates<2>& c, std::span<const Corner_2> corners)
        : density_(density), c_(c), corners_(corners), size_(size_of(c, corners)) {}

    Moments_2 moments() {
        const double x = density_.rate * size_.radius, y = density_.rate * size_.edge;
        if (x <= longest && y <= longest) {
            const auto errors = errors_of(density_.amplitude, x, y);
            const auto enough = [&](int n, double area, double mass) {
                while (n <= most_nodes && !(errors[static_cast<std::size_t>(n)] * area <= promise * mass)) ++n;
                return n;
            };
            // The number of nodes needed depends on the mass. This is a guess of the mass; where no number suffices for
            // it, few nodes give a better guess.
            double here = 0;
            density_.values(&c_[0], &c_[1], &here, 1);
            int n = enough(least_nodes, size_.area, size_.area * here / 2);
            if (n > most_nodes) n = least_nodes;
            while (n <= most_nodes) {
                add(1, n, radial_rule(n), false);
                const int needed = enough(n, area_, sum_.mass);
                if (needed == n) return sum_;
                n = needed;
            }
        }
        add(1 + static_cast<int>(x / longest), most_nodes, gauss_rule(most_nodes), true);
        return sum_;
    }

  private:
    /// Starts again, with `nodes` on edges or pieces of them and `pieces` of rays, each with `rule`; `lengths` gives
    /// that it is a rule for t f.
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
        evaluate();
    }

    /// A ray to u, of a boundary along d.
    void add_ray(const Coordinates<2>& u, const Coordinates<2>& d, int pieces, const Gauss_rule& rule, bool lengths) {
        const double part = 1.0 / pieces, share = u[0] * d[1] - u[1] * d[0];
        area_ += share / 2;
        for (int piece = 0; piece < pieces; ++piece) {
            if (waiting_ + most_nodes > room) evaluate();
            for (int k = 0; k < rule.size; ++k) {
                const auto j = static_cast<std::size_t>(k), i = static_cast<std::size_t>(waiting_ + k);
                const double t = (piece + rule.node[j]) * part;
                weight_[i] = share * rule.weight[j] * part * (lengths ? t : 1);
                from_c_[0][i] = t * u[0], from_c_[1][i] = t * u[1];
            }
            waiting_ += rule.size;
        }
    }

    /// The nodes at which the density is to be evaluated, many at a time: this dominates the time.
    void evaluate() {
        const auto n = static_cast<std::size_t>(waiting_);
        for (std::size_t k = 0; k < 2; ++k)
            for (std::size_t i = 0; i < n; ++i) at_[k][i] = c_[k] + from_c_[k][i];
        density_.values(at_[0].data(), at_[1].data(), value_.data(), waiting_);
        for (std::size_t i = 0; i < n; ++i) value_[i] *= weight_[i];
        for (std::size_t i = 0; i < n; ++i) {
            sum_.mass += value_[i];
            sum_.first[0] += value_[i] * from_c_[0][i];
            sum_.first[1] += value_[i] * from_c_[1][i];
        }
        waiting_ = 0;
    }

    static constexpr int room = 96;
    using Numbers = std::array<double, room>;

    const Density& density_;
    const Coordinates<2> c_;
    std::span<const Corner_2> corners_;
    Size_2 size_;
    Moments_2 sum_;
    double area_ = 0;
    int waiting_ = 0;
    std::array<Numbers, 2> from_c_, at_;
    Numbers weight_, value_;
};

/// The caller's function, called for one position after the other.
struct Any_density {
    const Smooth_density& density;
    double amplitude = density.amplitude, rate = density.rate;

    void values(const double* x, const double* y, double* f, int n) const {
        for (int i = 0; i < n; ++i) f[i] = density.at({x[i], y[i]});
    }
};

/// sin^2 of the distance from (0, 0), which is less than `farthest`.
struct Sin2 {
    static constexpr double amplitude = 0.5, rate = 2, farthest = 1e5;

    /// Several positions side by side: the loop has no branch that depends on the distance.
    static void values(const double* x, const double* y, double* f, int n) {
        constexpr int lanes = static_cast<int>(Lanes::size());
        const auto aligned = std::experimental::element_aligned;
        int i = 0;
        for (; i + lanes <= n; i += lanes) value(Lanes(x + i, aligned), Lanes(y + i, aligned)).copy_to(f + i, aligned);
        for (; i < n; ++i) f[i] = value(x[i], y[i]);
    }

  private:
    /// Relative error 1e-11, and that of r.
    template <class V>
    static V value(const V& x, const V& y) {
        using std::sqrt;
        const V r = sqrt(x * x + y * y);
        // Subtracts half turns, whose number is rounded by adding a large number; pi in three parts of 33 bits, so that
        // their products are exact (Cody and Waite).
        const V turns = (r * std::numbers::inv_pi + 0x1.8p52) - 0x1.8p52;
        const V s = ((r - turns * 0x1.921fb544p+1) - turns * 0x1.0b4611a6p-33) - turns * 0x1.3198a2ep-68, z = s * s;
        // Taylor's series up to s^15 as products of 1 - z / (2k (2k + 1)) within each other; for |s| <= pi / 2 it
        // leaves out 7e-12.
        static constexpr double part[] = {1. / 6, 1. / 20, 1. / 42, 1. / 72, 1. / 110, 1. / 156, 1. / 210};
        V series = 1 - z * part[6];
        for (int k = 5; k >= 0; --k) series = 1 - series * (z * part[k]);
        return z * (series * series);
    }
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
    return Cones(Any_density{density}, origin, corners).moments();
}

Moments_2 sin2_moments(const Coordinates<2>& origin, std::span<const Corner_2> corners) {
    if (corners.empty()) return {};
    if (norm(origin) + size_of(origin, corners).radius < Sin2::farthest)
        return Cones(Sin2{}, origin, corners).moments();
    const auto at = [](const Coordinates<2>& p) { return density_at(Density::sin2, p); };
    static const Smooth_density sin2{at, 1, Sin2::amplitude, Sin2::rate};
    return smooth_moments(sin2, origin, corners);
}

}  // namespace annulus::inline v1
