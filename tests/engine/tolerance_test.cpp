// SPDX-License-Identifier: GPL-3.0-or-later
// Guarantees of tolerances: never above the truth, not far below it, and moves inside it change nothing.
#include <annulus/arithmetic/limits.h>

#include <common/half_widths.h>

#include <gmpxx.h>
#include <rapidcheck.h>

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/checked_mesh.h>
#include <support/harm.h>
#include <support/small_sets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

using namespace annulus;
using namespace annulus::oracle;
using annulus::testing::between;
using annulus::testing::cells_of;
using annulus::testing::Family;
using annulus::testing::for_all;
using annulus::testing::Point_set_case;
using annulus::testing::point_set_case;
using annulus::testing::Random;
using annulus::testing::Viewed_mesh_2;

namespace {

using Session = annulus::testing::Checked_mesh<2>;

/// A fault of the session as a failed assertion.
template <class Body>
void without_fault(Body body) {
    try {
        body();
    } catch (const Session_fault& fault) {
        RC_FAIL(fault.words);
    }
}

/// A point at distance `share` times r from p at most: towards or away from `target` for kinds 0 and 1, else in a
/// random direction.
Position shifted(const Position& p, double r, double share, const Position& target, int kind, Random& random) {
    double angle = between(random, 0.0, 6.283185307179586);
    if (kind < 2) angle = std::atan2(target[1] - p[1], target[0] - p[0]) + (kind == 1 ? 3.141592653589793 : 0.0);
    const double step = share * r;
    Position q{p[0] + step * std::cos(angle), p[1] + step * std::sin(angle)};
    if (std::fabs(q[0]) > 0x1p500 || std::fabs(q[1]) > 0x1p500) return p;
    // Far from the origin the sum may round to a point farther away than requested: use p then.
    const mpq_class dx = mpq_class(q[0]) - mpq_class(p[0]);
    const mpq_class dy = mpq_class(q[1]) - mpq_class(p[1]);
    const mpq_class reach = mpq_class(r) * mpq_class(0.99995);
    return share >= 1.0 || dx * dx + dy * dy < reach * reach ? q : p;
}

/// The worst target of v: in the tightest annulus of v, inner points move outward and outer ones inward; its own
/// position where a vertex has no annulus.
std::vector<Position> worst_targets(const Viewed_mesh_2& dt) {
    const auto at = [](Index i) { return static_cast<std::size_t>(i); };
    std::vector<Position> target(dt.points().begin(), dt.points().end());
    std::vector<double> least(target.size(), std::numeric_limits<double>::infinity());
    for (const auto& v : dt.view_bicells()) {
        const auto x = [&](std::size_t k) { return dt.points()[at(v[k])]; };
        const double w = half_annulus(x(0), x(1), x(2), x(3)).get_d();
        // Relative to the first point, scaled to about 1.
        double m = 0.0;
        for (std::size_t k = 1; k < 4; ++k)
            for (std::size_t c = 0; c < 2; ++c) m = std::max(m, std::fabs(x(k)[c] - x(0)[c]));
        const int exponent = -std::ilogb(m);
        std::array<Position, 4> y{};
        for (std::size_t k = 1; k < 4; ++k)
            for (std::size_t c = 0; c < 2; ++c) y[k][c] = std::ldexp(x(k)[c] - x(0)[c], exponent);
        const double vx = y[3][0] - y[2][0];
        const double vy = y[3][1] - y[2][1];
        const double r1 = 0.5 * (y[1][0] * y[1][0] + y[1][1] * y[1][1]);
        const double r2 = 0.5 * (vx * (y[2][0] + y[3][0]) + vy * (y[2][1] + y[3][1]));
        const double det = y[1][0] * vy - y[1][1] * vx;
        const Position centre{x(0)[0] + std::ldexp((r1 * vy - y[1][1] * r2) / det, -exponent),
                              x(0)[1] + std::ldexp((y[1][0] * r2 - r1 * vx) / det, -exponent)};
        if (!std::isfinite(centre[0]) || !std::isfinite(centre[1])) continue;
        for (std::size_t k = 0; k < 4; ++k) {
            if (!(w < least[at(v[k])])) continue;
            least[at(v[k])] = w;
            target[at(v[k])] = k < 2 ? Position{2.0 * x(k)[0] - centre[0], 2.0 * x(k)[1] - centre[1]} : centre;
        }
    }
    return target;
}

[[nodiscard]] bool distinct(const std::vector<Position>& x) {
    return std::set<Position>(x.begin(), x.end()).size() == x.size();
}

/// One time step, applied and checked: vertex i moves from x[i] to step(i, its worst target). False, with nothing
/// changed, when two would be duplicate points.
template <class Step>
bool drift(Session& session, std::vector<Position>& x, Step step) {
    const auto target = worst_targets(session.dt());
    std::vector<Position> y = x;
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = step(i, target[i]);
    if (!distinct(y)) return false;
    x = y;
    session.apply(move_all(x));
    session.check();
    return true;
}

/// `share` of its tolerance from its fixed position.
Position from_fixed(Session& session, std::size_t i, double share, const Position& target, int kind, Random& random) {
    const auto v = static_cast<Index>(i);
    return shifted(session.dt().fixed_position(v), session.dt().tolerance(v), share, target, kind, random);
}

constexpr Setting tolerance_setting{Strategy::tolerances};
constexpr Setting tolerances_each{Strategy::tolerances_each};

/// sum of D^2 must be a normal number for the comparison of squares to be accurate enough for any guarantee.
bool squares_underflow(Family family) {
    return family == Family::subnormal || family == Family::mixture || family == Family::tiny;
}

}  // namespace

TEST_CASE("A recomputed tolerance is never above the exact one and within 0.2 % of it, under every strategy",
          "[tolerance]") {
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(name_of(setting)) {
            REQUIRE(for_all([setting] {
                const auto set = *point_set_case(0, 30);
                without_fault([&] {
                    Session session(Program{setting, set.points, {}});
                    session.check_recomputed_tolerances();
                    Random random(set.seed + 1);
                    session.apply(move_all(annulus::testing::point_set(set.family, set.points.size(), random)));
                    session.apply(recompute_tolerances());
                    session.check_recomputed_tolerances();
                });
            }));
        }
    }
}

TEST_CASE("Tolerances after a drift leave the vertices of no certificate more than undoes it", "[tolerance]") {
    for (const Setting& setting : {tolerance_setting, tolerances_each}) {
        DYNAMIC_SECTION(name_of(setting)) {
            REQUIRE(for_all([setting] {
                const auto set = *point_set_case(4, 25);
                without_fault([&] {
                    Session session(Program{setting, set.points, {}});
                    Random random(set.seed + 1);
                    std::vector<Position> x = set.points;
                    for (int step = 0; step < 8; ++step) {
                        (void)drift(session, x, [&](std::size_t i, const Position& target) {
                            return from_fixed(session, i, between(random, 0.3, 3.0), target,
                                              static_cast<int>(random() % 3), random);
                        });
                        if (step % 4 != 3) continue;
                        if (const std::string words = annulus::testing::room_fault(session.dt()); !words.empty())
                            throw Session_fault{words};
                    }
                });
            }));
        }
    }
}

TEST_CASE("The most harmful moves, just inside and just outside the tolerances, leave nothing wrong", "[tolerance]") {
    // Few points, so that the certificate that decides one vertex decides its neighbours too. The scale is one where
    // squares of tolerances are subnormal.
    for (const Setting& setting : {tolerance_setting, tolerances_each}) {
        DYNAMIC_SECTION(name_of(setting)) {
            REQUIRE(for_all([setting] {
                Random random(*annulus::testing::seeds());
                for (int repeat = 0; repeat < 10; ++repeat) {
                    const std::size_t n = 4 + random() % 3;
                    std::vector<Position> x = annulus::testing::point_set(Family::uniform, n, random);
                    const int exponent = random() % 3 == 0 ? -528 - static_cast<int>(random() % 9) : 0;
                    for (Position& p : x)
                        for (double& c : p) c = std::ldexp(c, exponent);
                    without_fault([&] {
                        Session session(Program{setting, x, {}});
                        for (int step = 0; step < 5; ++step) {
                            const std::size_t all = random() % 2;
                            const double share =
                                std::array{0.9999, 1.002, 1.03, 1.12, between(random, 0.3, 1.9)}[random() % 5];
                            const int away = random() % 3 == 0 ? 1 : 0;  // so far that the way back is longer
                            const bool apart = drift(session, x, [&](std::size_t i, const Position& target) {
                                if (all == 0 && random() % 2 == 0) return x[i];
                                return from_fixed(session, i, share, target, away, random);
                            });
                            if (!apart) break;
                        }
                    });
                }
            }));
        }
    }
}

TEST_CASE("Moves of 0.9999 tolerances, all at once, evaluate nothing and keep the triangulation",
          "[tolerance][tight]") {
    for (const Setting& setting : {tolerance_setting, tolerances_each}) {
        DYNAMIC_SECTION(name_of(setting)) {
            REQUIRE(for_all([setting] {
                const auto set = *point_set_case(3, 30);
                RC_PRE(!squares_underflow(set.family));
                without_fault([&] {
                    Session session(Program{setting, set.points, {}});
                    Random random(set.seed + 1);
                    const auto target = worst_targets(session.dt());
                    const Cells before = cells_of(session.dt());
                    for (int kind = 0; kind < 4; ++kind) {
                        std::vector<Position> x = set.points;
                        for (std::size_t i = 0; i < x.size(); ++i)
                            x[i] = shifted(x[i], session.dt().tolerance(static_cast<Index>(i)), 0.9999, target[i],
                                           kind < 3 ? kind : static_cast<int>(random() % 2), random);
                        if (!distinct(x)) continue;
                        session.apply(move_all(x));
                        session.check();
                        if (session.dt().view_dimension() < 2) continue;
                        RC_ASSERT(session.last().statistics.evaluated == 0U);
                        RC_ASSERT(session.last().moves.within_tolerance == x.size());
                        RC_ASSERT(cells_of(session.dt()) == before);
                    }
                });
            }));
        }
    }
}

TEST_CASE(
    "The worst moves of every certificate of the plane, by 0.9999 of the vertices' tolerances and by a little more",
    "[tolerance][tight]") {
    for (const Setting& setting : {tolerance_setting, tolerances_each}) {
        DYNAMIC_SECTION(name_of(setting)) {
            annulus::testing::Undone undone;
            REQUIRE(for_all([&undone, setting](const annulus::testing::Seed& seed) {
                Random random = seed.random();
                const auto set = annulus::testing::all_small_sets[random() % annulus::testing::all_small_sets.size()];
                const double off = std::ldexp(1.0, -annulus::testing::integer(random, 2, 22));
                annulus::testing::check_worst_moves<Viewed_mesh_2>(
                    annulus::testing::small_set<2>(set, 3 + random() % 8, off, random), options_of(setting), undone);
            }));
            std::printf("plane: %d triangulations of %d certificates, %d tight; all of these undone\n",
                        undone.triangulations, undone.certificates, undone.tight);
            CHECK(undone.tight >= undone.triangulations);
        }
    }
}

TEST_CASE("Whenever a drifting call reports all within tolerance the audit passes", "[tolerance]") {
    for (const Setting& setting : {tolerance_setting, tolerances_each}) {
        DYNAMIC_SECTION(name_of(setting)) {
            REQUIRE(for_all([setting] {
                const auto set = *point_set_case(4, 25);
                without_fault([&] {
                    Session session(Program{setting, set.points, {}});
                    Random random(set.seed + 1);
                    std::vector<double> spacing(set.points.size());
                    for (std::size_t i = 0; i < spacing.size(); ++i)
                        spacing[i] = session.dt().tolerance(static_cast<Index>(i));
                    std::vector<Position> x = set.points;
                    const bool steady = random() % 2 == 0;
                    for (int step = 0; step < 20; ++step)
                        (void)drift(session, x, [&](std::size_t i, const Position& target) {
                            return shifted(x[i], spacing[i], between(random, 0.01, 0.4), target, steady ? 0 : 2,
                                           random);
                        });
                });
            }));
        }
    }
}
