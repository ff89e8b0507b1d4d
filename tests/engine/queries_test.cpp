// SPDX-License-Identifier: GPL-3.0-or-later
// Queries of an object (measure, theta, displacement) compared with independent computations.
#include <annulus/arithmetic/limits.h>

#include <common/half_widths.h>
#include <common/operation.h>

#include <support/cases.h>
#include <support/oracle_3.h>
#include <support/viewed_mesh.h>

#include <cmath>
#include <limits>

using namespace annulus;
using namespace annulus::oracle;
using namespace annulus::testing;

namespace {

constexpr double right_angle = 1.5707963267948966;

using Real = long double;
template <std::size_t d>
std::array<Real, d> between_points(const std::array<double, d>& a, const std::array<double, d>& b) {
    std::array<Real, d> v;
    for (std::size_t k = 0; k < d; ++k) v[k] = static_cast<Real>(b[k]) - static_cast<Real>(a[k]);
    return v;
}
template <std::size_t d>
Real dot_product(const std::array<Real, d>& u, const std::array<Real, d>& v) {
    Real s = 0;
    for (std::size_t k = 0; k < d; ++k) s += u[k] * v[k];
    return s;
}
/// u without its component along v.
template <std::size_t d>
std::array<Real, d> rejected(std::array<Real, d> u, const std::array<Real, d>& v) {
    const Real share = dot_product(u, v) / dot_product(v, v);
    for (std::size_t k = 0; k < d; ++k) u[k] -= share * v[k];
    return u;
}

/// The angle between the line p q and the facet: the component of q - p perpendicular to the facet over the one in it.
/// No normal is computed.
template <int d>
double angle_of(const std::array<Coordinates<d>, static_cast<std::size_t>(d + 2)>& x) {
    const auto e = between_points(x[d], x[d + 1]);
    const auto u = between_points(x[0], x[1]);
    auto out = rejected(e, u);
    if constexpr (d == 3) out = rejected(out, rejected(between_points(x[0], x[2]), u));
    const Real leaves = dot_product(out, out);
    const Real stays = dot_product(e, e) - leaves;
    return static_cast<double>(std::atan2(std::sqrt(leaves), std::sqrt(std::max<Real>(stays, 0))));
}

/// Twice the least half width.
double width_of(const std::array<Coordinates<2>, 4>& x) {
    const auto [a, b, p, q] = x;
    return 2.0 * half_annulus(a, b, p, q).get_d();
}
double width_of(const std::array<Coordinates<3>, 5>& x) {
    Bicell_3 c{x[0], x[1], x[2], x[3], x[4]};
    if (exact_orientation(c.a, c.b, c.c, c.q) < 0) std::swap(c.a, c.b);
    const Bicell_3_truth truth(c, false);
    return truth.sign() > 0 ? 2.0 * truth.enclosure().middle() : 0.0;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("measure() and theta() are what definitions give, dimension", "[queries]", ((int d), d), 2, 3) {
    using Moving = Viewed_mesh<d>;
    for_each_seed(d == 2 ? 60 : 20, [](Random& random) {
        const auto set = random() % 2 == 0 ? all_sets<d>()[0] : ordinary_set<d>(random);
        const bool round_off = set == all_sets<d>()[0];  // elsewhere angles may be rounding noise
        Moving dt(some_points<d>(set, 0, d == 2 ? 30 : 15, random), {});
        Points_of<d> x(dt.points().begin(), dt.points().end());
        for (auto& p : x)
            for (double& c : p) c += 0x1p-9 * between(random, -1.0, 1.0);
        dt.move_all(x);
        dt.recompute_tolerances();
        const Measures m = dt.measure();
        REQUIRE(m.tolerance.size() == x.size());
        std::vector<double> widths;
        double least = right_angle;
        std::vector<double> least_at(x.size(), right_angle);
        for (const Bicell_indices<d>& bicell : dt.view_bicells()) {
            std::array<Coordinates<d>, static_cast<std::size_t>(d + 2)> corner;
            for (std::size_t k = 0; k < corner.size(); ++k) corner[k] = x[static_cast<std::size_t>(bicell[k])];
            widths.push_back(width_of(corner));
            const double angle = angle_of<d>(corner);
            least = std::min(least, angle);
            for (const Index v : bicell)
                least_at[static_cast<std::size_t>(v)] = std::min(least_at[static_cast<std::size_t>(v)], angle);
        }
        REQUIRE(m.annulus_width.size() == widths.size());
        std::vector<double> found = m.annulus_width;
        std::sort(found.begin(), found.end());
        std::sort(widths.begin(), widths.end());
        for (std::size_t i = 0; i < widths.size(); ++i) {
            CHECK(found[i] <= widths[i] * (1.0 + 1e-14));
            CHECK(found[i] >= widths[i] * 0.998);
        }
        if (round_off) {
            CHECK(std::fabs(m.theta_min - least) <= 1e-9);
            for (std::size_t i = 0; i < x.size(); ++i)
                CHECK(std::fabs(dt.theta(static_cast<Index>(i)) - least_at[i]) <= 1e-9);
        }
        for (std::size_t i = 0; i < x.size(); ++i) {  // recomputed tolerances have their own oracles (program.h)
            const double s = dt.tolerance(static_cast<Index>(i));
            if (dt.view_dimension() < d) CHECK(m.tolerance[i] == std::numeric_limits<double>::infinity());
            else CHECK(std::fabs(m.tolerance[i] - s) <= (Limits::tiny ? 1.0 : 0x1p-8) * m.tolerance[i]);
        }
    });
}

TEMPLATE_TEST_CASE_SIG("displacement() is the distance from the fixed position, from above and closely, dimension",
                       "[queries]", ((int d), d), 2, 3) {
    using Moving = Viewed_mesh<d>;
    for (const Setting& setting : certified_settings) {
        CAPTURE(name_of(setting));
        Options options;
        options.strategy = setting.strategy;
        const bool keeps = setting.strategy == Strategy::tolerances || setting.strategy == Strategy::tolerances_each ||
                           setting.strategy == Strategy::paper;
        bool moved = false;
        for_each_seed(keeps ? 10 : 2, [&](Random& random) {
            Moving dt(some_points<d>(any_set<d>(random), d + 2, 12, random), options);
            for (int step = 0; step < 6; ++step) {
                Points_of<d> x(dt.points().begin(), dt.points().end());
                for (std::size_t i = 0; i < x.size(); ++i) {
                    const double room =
                        keeps ? std::min(dt.tolerance(static_cast<Index>(i)), 0x1p400) : 0x1p-20 * x[i][0];
                    for (double& c : x[i]) c += room * std::ldexp(between(random, -1.0, 1.0), -integer(random, 0, 40));
                }
                try {
                    dt.move_all(x);
                } catch (const Error&) {
                    continue;  // duplicate points, or a vertex outside the domain
                }
                for (std::size_t i = 0; i < x.size(); ++i) {
                    const auto v = static_cast<Index>(i);
                    const Coordinates<d> p = dt.position(v), f = dt.fixed_position(v);
                    CHECK(p == x[i]);
                    mpq_class squares = 0;
                    for (std::size_t k = 0; k < d; ++k) {
                        const mpq_class c = mpq_class(p[k]) - mpq_class(f[k]);
                        squares += c * c;
                    }
                    const mpq_class found(dt.displacement(v));
                    CHECK(found * found >= squares);
                    if (squares > mpq_class(0x1p-890)) CHECK(found * found <= squares * (1 + mpq_class(0x1p-40)));
                    if (squares == 0) CHECK(found == 0);
                    moved |= squares > 0;
                }
            }
        });
        if (!keeps && setting.strategy != Strategy::paper_hybrid && setting.strategy != Strategy::automatic)
            CHECK(!moved);
    }
    // Some families have no positive tolerance at all: here there is one.
    Random random(1);
    Points_of<d> x(40);
    for (auto& p : x)
        for (double& c : p) c = between(random, -1.0, 1.0);
    Moving dt(x, {.strategy = Strategy::tolerances});
    for (std::size_t i = 0; i < x.size(); ++i) x[i][0] += 0.5 * dt.tolerance(static_cast<Index>(i));
    dt.move_all(x);
    CHECK(dt.displacement(0) > 0.0);
}
