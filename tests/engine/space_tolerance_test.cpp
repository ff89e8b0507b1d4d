// SPDX-License-Identifier: GPL-3.0-or-later
// Guarantees of tolerances in 3D: hand-computed values, the paper's counterexample, and moves just inside.
#include <annulus/predicate/filtered_3.h>

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/checked_mesh.h>
#include <support/harm.h>
#include <support/point_sets_3.h>
#include <support/small_sets.h>

#include <cmath>

using namespace annulus;
using namespace annulus::testing;
using oracle::Program_3;
using oracle::Session_fault;
using Session_3 = Checked_mesh<3>;
using Kind = oracle::Operation_kind;

namespace {

constexpr std::array filters{Strategy::tolerances, Strategy::tolerances_each};

/// docs/theory.md 3.
Points_3 spindle(double delta) {
    const double s = std::sqrt(0.75);
    return {{0, 0, 1 - delta}, {0, 0, delta - 1}, {1, 0, 0}, {-0.5, s, 0}, {-0.5, -s, 0}};
}
Points_3 spindle_grown(double by) {
    Points_3 x = spindle(0.01);
    x[0][2] += by;
    x[1][2] -= by;
    for (std::size_t i = 2; i < 5; ++i)
        for (double& c : x[i]) c *= 1 - by;
    return x;
}

Options options_of(Strategy strategy, Tolerance_kind kind) {
    Options o;
    o.strategy = strategy;
    o.tolerance = kind;
    return o;
}

/// Bounds of the least half width of all cells, bi-cells and ridges that contain a vertex, in rational numbers. The
/// widths of a bi-cell's cells count where a partition is on the wrong side, and may count where the filter cannot
/// decide that (docs/theory.md 2.2).
struct True_tolerances {
    std::vector<double> least, most;
    explicit True_tolerances(const Viewed_mesh_3& dt)
        : least(dt.index_bound(), std::numeric_limits<double>::infinity()), most(least) {
        const Audit_input<3> input = dt.audit_input();
        if (input.cells.empty() || input.cells.front()[3] == none) return;
        const auto lower = [](std::vector<double>& bound, const auto& vertices, const mpf_class& half_width) {
            for (const Index v : vertices) {
                double& b = bound[static_cast<std::size_t>(v)];
                b = std::min(b, half_width.get_d());
            }
        };
        const auto all = certificates_of<3>(input.cells);
        for (const auto* simplices : {&all.cells, &all.ridges})
            for (const auto& c : *simplices) {
                const auto x = points_of<3>(c, input.points);
                const auto squeezes = slabs<mpq_class, 3>(x);
                for (auto* bound : {&least, &most}) lower(*bound, c, least_of(squeezes).half_width);
            }
        for (const auto& b : all.bicells) {
            const auto x = points_of<3>(b, input.points);
            auto squeezes = annuli<mpq_class, 3>(x);
            const bool wrong_side =
                !std::all_of(squeezes.begin(), squeezes.end(), [](const auto& s) { return s.inner; });
            const bool perhaps =
                wrong_side || evaluate_empty_sphere({&x[0], &x[1], &x[2], &x[3], &x[4]}).wrong_side != 0;
            if (!wrong_side) lower(most, b, least_of(squeezes).half_width);
            if (perhaps)
                for (const bool with_q : {false, true})
                    for (const auto& s : slabs_of_cell<mpq_class, 3>(x, with_q)) squeezes.push_back(s);
            if (wrong_side) lower(most, b, least_of(squeezes).half_width);
            lower(least, b, least_of(squeezes).half_width);
        }
    }
};

enum class Way { worst, back, any };

/// p moved by `length`: in the worst direction, the opposite one, or a random one.
Coordinates<3> shifted(const Coordinates<3>& p, double length, const Coordinates<3>& worst, Way way, Random& random) {
    if (!std::isfinite(length)) return p;
    if (way != Way::any) return stepped(p, worst, way == Way::worst ? length : -length);
    Coordinates<3> u{between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
    return stepped(p, u, length / std::hypot(u[0], u[1], u[2]));
}

}  // namespace

TEST_CASE("The tolerances of a regular tetrahedron and of the spindle are those computed by hand",
          "[tolerance][space][tight]") {
    for (const Strategy strategy : filters) {
        CAPTURE(name_of(strategy));
        // Edge 2 sqrt 2: the distance of opposite edges is 2, the height 2.309; half the width is 1. A ridge is the
        // same four points.
        Viewed_mesh_3 one(Points_3{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                          options_of(strategy, Tolerance_kind::certified));
        for (Index i = 0; i < 4; ++i) {
            CHECK(one.tolerance(i) <= 1.0);
            CHECK(one.tolerance(i) > 0.998);
        }
        // Spheres around the origin of radius 0.99 and 1.
        Viewed_mesh_3 five(spindle(0.01), options_of(strategy, Tolerance_kind::certified));
        Viewed_mesh_3 paper(spindle(0.01), options_of(Strategy::paper, Tolerance_kind::paper));
        for (Index i = 0; i < 5; ++i) {
            CHECK(five.tolerance(i) <= 0.005 * (1 + 1e-12));
            CHECK(five.tolerance(i) > 0.998 * 0.005);
            CHECK(std::fabs(paper.tolerance(i) - 0.00748) < 0.00001);
        }
    }
}

TEST_CASE("Inside the paper's tolerances the spindle ends in a triangulation that the audit refuses, certified never",
          "[tolerance][space]") {
    for (const Strategy strategy : filters) {
        CAPTURE(name_of(strategy));
        for (const Tolerance_kind kind : {Tolerance_kind::certified, Tolerance_kind::paper}) {
            Viewed_mesh_3 dt(spindle(0.01),
                             options_of(kind == Tolerance_kind::paper ? Strategy::paper : strategy, kind));
            CHECK(dt.view_cells().size() == 3);
            const Move_result report = dt.move_all(spindle_grown(0.007));
            const bool right = dt.audit().delaunay();
            CHECK(right == (kind == Tolerance_kind::certified));
            if (kind == Tolerance_kind::paper) {
                CHECK(report.moves.within_tolerance == 5);
            } else {
                CHECK(dt.view_cells().size() == 2);
                CHECK(report.statistics.flips == 1);
            }
        }
        // One vertex at a time, and back: always right.
        Session_3 session(strategy, spindle(0.01));
        try {
            for (int k = 0; k < 20; ++k)
                for (Index v = 0; v < 5; ++v) {
                    session.apply({Kind::move,
                                   v,
                                   {(k % 2 == 0 ? spindle_grown(0.007) : spindle(0.01))[static_cast<std::size_t>(v)]}});
                    session.check();
                }
        } catch (const Session_fault& fault) {
            FAIL(fault.words);
        }
    }
}

TEST_CASE("A recomputed tolerance in space is never above what its certificates allow and within 0.2 % of it",
          "[tolerance][space][tight]") {
    for (const Strategy strategy : filters) {
        DYNAMIC_SECTION(name_of(strategy)) {
            REQUIRE(for_all([=] {
                const Set_3 set = all_sets_3[*rc::gen::inRange<std::size_t>(0, all_sets_3.size())];
                Random random(*seeds());
                const Viewed_mesh_3 dt(point_set(set, 4 + random() % 12, random),
                                       options_of(strategy, Tolerance_kind::certified));
                if (dt.view_dimension() < 3) return;
                const True_tolerances truth(dt);
                for (std::size_t i = 0; i < dt.index_bound(); ++i) {
                    const double found = dt.tolerance(static_cast<Index>(i));
                    RC_ASSERT(found <= truth.most[i] * (1 + 0x1p-52));
                    // Rounding to subnormal numbers may lose all accuracy.
                    RC_ASSERT(found >= 0.998 * truth.least[i] || found < 0x1p-1000);
                }
            }));
        }
    }
}

TEST_CASE("The most harmful moves in space, just inside and just outside the tolerances, leave nothing wrong",
          "[tolerance][space]") {
    for (const Strategy strategy : filters) {
        DYNAMIC_SECTION(name_of(strategy)) {
            REQUIRE(for_all([=] {
                const Set_3 set = all_sets_3[*rc::gen::inRange<std::size_t>(0, all_sets_3.size())];
                const auto seed = *seeds();
                Random random(seed);
                const std::size_t n = 4 + random() % 12;
                Points_3 x = point_set(set, n, random);
                Program_3 program{strategy, x, {}};
                try {
                    Session_3 session(strategy, x);
                    for (int step = 0; step < 8; ++step) {
                        const auto worst = harmful_directions(session.dt());
                        const double share = std::array{0.9999, 0.9999, 1.002, 1.3, 3.0}[random() % 5];
                        const auto way = static_cast<Way>(random() % 3);
                        Points_3 y = x;
                        for (std::size_t i = 0; i < n; ++i) {
                            if (random() % 4 == 0) continue;
                            const auto v = static_cast<Index>(i);
                            y[i] = shifted(session.dt().fixed_position(v), share * session.dt().tolerance(v), worst[i],
                                           way, random);
                        }
                        Points_3 sorted = y;
                        std::sort(sorted.begin(), sorted.end());
                        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) continue;
                        x = y;
                        program.operations.push_back({Kind::move_all, none, x});
                        session.apply(program.operations.back());
                        session.check();
                        if (n <= 8)
                            if (const std::string words = room_fault(session.dt()); !words.empty())
                                throw Session_fault{words};
                    }
                } catch (const Session_fault& fault) {
                    RC_FAIL(fault.words + "\n" + as_code(program));
                }
            }));
        }
    }
}

TEST_CASE("Moves of 0.9999 tolerances in space evaluate nothing and keep the triangulation",
          "[tolerance][space][tight]") {
    for (const Strategy strategy : filters) {
        CAPTURE(name_of(strategy));
        Random random(23);
        const Points_3 home = point_set(Set_3::uniform, 300, random);
        for (const Way way : {Way::worst, Way::back, Way::any}) {
            Viewed_mesh_3 dt(home, options_of(strategy, Tolerance_kind::certified));
            const auto worst = harmful_directions(dt);
            const auto before = cells_of(dt);
            Points_3 x = home;
            for (std::size_t i = 0; i < x.size(); ++i)
                x[i] = shifted(x[i], 0.9999 * dt.tolerance(static_cast<Index>(i)), worst[i], way, random);
            const Move_result report = dt.move_all(x);
            CHECK(report.statistics.evaluated == 0);
            CHECK(report.moves.within_tolerance == x.size());
            CHECK(cells_of(dt) == before);
            CHECK(dt.audit().delaunay());
        }
    }
}

TEST_CASE("The worst moves of every certificate of space, by 0.9999 of the vertices' tolerances and by a little more",
          "[tolerance][space][tight]") {
    for (const Strategy strategy : filters) {
        DYNAMIC_SECTION(name_of(strategy)) {
            Undone undone;
            REQUIRE(for_all([&undone, strategy](const Seed& seed) {
                Random random = seed.random();
                const testing::Small_set set = all_small_sets[random() % all_small_sets.size()];
                const double off = std::ldexp(1.0, -integer(random, 2, 22));
                check_worst_moves<Viewed_mesh_3>(small_set<3>(set, 4 + random() % 5, off, random),
                                                 options_of(strategy, Tolerance_kind::certified), undone);
            }));
            std::printf("space: %d triangulations of %d certificates, %d tight; all of these undone\n",
                        undone.triangulations, undone.certificates, undone.tight);
            CHECK(undone.tight >= undone.triangulations);
        }
    }
}
