// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of a call that moves some vertices, where each of them changes everything: counted in cells tested,
// certificates and bytes allocated.
#include <annulus/engine/cost_model.h>
#include <annulus/moving_mesh.h>

#include <support/catch.h>
#include <support/failing_new.h>
#include <support/generators.h>
#include <support/viewed_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace annulus;
using annulus::testing::between;
using annulus::testing::Failing_new;
using annulus::testing::Random;
using annulus::testing::unit;

namespace {

template <int d>
using Delaunay_of = testing::Viewed_mesh<d>;

enum class Scene { sphere, moment_curve };

/// On the unit sphere, up to rounding; or on the curve (t, t^2, ..), where in 3D every two vertices are neighbours.
template <int d>
std::vector<Coordinates<d>> convex_position(Scene scene, std::size_t n, Random& random) {
    std::vector<Coordinates<d>> x;
    while (x.size() < n) {
        Coordinates<d> p{};
        double square = 0.0;
        for (double& c : p) {
            c = between(random, -1.0, 1.0);
            square += c * c;
        }
        if (scene == Scene::sphere && (square > 1.0 || square < 0.01)) continue;
        const double t = unit(random);
        double power = 1.0;
        for (double& c : p) c = scene == Scene::sphere ? c / std::sqrt(square) : power *= t;
        x.push_back(p);
    }
    return x;
}

template <int d>
constexpr std::size_t vertices_of(Scene scene) {
    return d == 2 ? 1280 : scene == Scene::sphere ? 1280 : 192;
}

const Strategy certified[] = {Strategy::tolerances, Strategy::automatic, Strategy::tolerances_each, Strategy::in_place};

/// A 64th of all vertices, so that they are moved one by one.
template <int d>
void choose(std::span<const Coordinates<d>> x, double pace, Random& random, std::vector<Index>& index,
            std::vector<Coordinates<d>>& target) {
    index.clear();
    target.clear();
    for (std::size_t k = 0; k < x.size() / 64; ++k) {
        const auto i = static_cast<std::size_t>(random() % x.size());
        index.push_back(static_cast<Index>(i));
        target.push_back(x[i]);
        for (double& c : target.back()) c += pace * between(random, -1.0, 1.0);
    }
}

template <int d, class Triangulation>
void check_cost(Scene scene, double pace) {
    for (const Strategy strategy : certified) {
        CAPTURE(d, static_cast<int>(scene), pace, name_of(strategy));
        Random random(3);
        std::vector<Coordinates<d>> x = convex_position<d>(scene, vertices_of<d>(scene), random);
        Options options, plain;
        options.strategy = strategy;
        plain.strategy = Strategy::rebuild;
        Triangulation dt(std::span<const Coordinates<d>>(x), options);
        const auto n = static_cast<double>(x.size());
        const auto cells = static_cast<double>(dt.cells().vertices.size());
        std::vector<Index> index;
        std::vector<Coordinates<d>> target;
        for (int step = 0; step < 3; ++step) {
            choose<d>(x, pace, random, index, target);
            for (std::size_t k = 0; k < index.size(); ++k) x[static_cast<std::size_t>(index[k])] = target[k];
            std::uint64_t spent = 0, once = 0;
            Move_result report;
            {
                const Failing_new counting(std::uint64_t{1} << 60);
                report = dt.move(std::span<const Index>(index), std::span<const Coordinates<d>>(target));
                spent = Failing_new::bytes();
            }
            {
                const Failing_new counting(std::uint64_t{1} << 60);
                const Triangulation fresh(std::span<const Coordinates<d>>(x), plain);
                once = Failing_new::bytes();
            }
            CAPTURE(step, report.statistics.cost / (Cost_model<d>::rebuild * n), report.statistics.evaluated,
                    spent / once, report.moves.reinserted, report.moves.rebuilt);
            CHECK(report.statistics.cost < 6.0 * Cost_model<d>::rebuild * std::max(n, cells / (d == 2 ? 2.0 : 6.7)));
            CHECK(static_cast<double>(report.statistics.evaluated) < 60.0 * cells);
            CHECK(spent < 10 * once);
            REQUIRE(std::equal(x.begin(), x.end(), dt.points().begin()));
            REQUIRE(dt.audit().delaunay());
        }
    }
}

/// The target of the last mover is the position of a vertex that does not move.
template <int d, class Triangulation>
void check_duplicate_point(Scene scene) {
    for (const Strategy strategy : certified) {
        CAPTURE(d, static_cast<int>(scene), name_of(strategy));
        Random random(4);
        const std::vector<Coordinates<d>> x = convex_position<d>(scene, vertices_of<d>(scene), random);
        Options options;
        options.strategy = strategy;
        Triangulation dt(std::span<const Coordinates<d>>(x), options);
        std::vector<Index> index;
        std::vector<Coordinates<d>> target;
        const auto last = static_cast<Index>(x.size() - 1);
        for (int step = 0; step < 2; ++step) {
            choose<d>(x, 1e-3, random, index, target);
            std::size_t kept = 0;
            for (std::size_t k = 0; k < index.size(); ++k) {
                if (index[k] == 0 || index[k] == last) continue;
                index[kept] = index[k];
                target[kept++] = target[k];
            }
            index.resize(kept);
            target.resize(kept);
            index.push_back(0);
            target.push_back(x[static_cast<std::size_t>(last)]);
            try {
                (void)dt.move(std::span<const Index>(index), std::span<const Coordinates<d>>(target));
                FAIL("two vertices at one place");
            } catch (const Error& e) {
                CHECK(e.code() == Error_code::duplicate_point);
            }
            REQUIRE(std::equal(x.begin(), x.end(), dt.points().begin()));
            REQUIRE(dt.audit().delaunay());
            // If that vertex moves away, it is not a duplicate point.
            Triangulation other(std::span<const Coordinates<d>>(x), options);
            index.push_back(last);
            target.push_back(x[0]);
            (void)other.move(std::span<const Index>(index), std::span<const Coordinates<d>>(target));
            REQUIRE(other.points()[0] == x[static_cast<std::size_t>(last)]);
            REQUIRE(other.audit().delaunay());
        }
    }
}

/// Some points, uniform in the unit box, move by so many spacings in random directions: the cost of a call per mover.
template <int d>
void check_far(Strategy strategy, std::size_t n, std::size_t movers, double spacings) {
    CAPTURE(d, name_of(strategy), n, movers, spacings);
    Random random(5);
    std::vector<Coordinates<d>> x(n);
    for (auto& p : x)
        for (double& c : p) c = unit(random);
    Options options;
    options.strategy = strategy;
    Moving_mesh<d> mesh(std::span<const Coordinates<d>>(x), options);
    // With tolerances, those of the changed certificates are evaluated too.
    const bool tolerances = strategy == Strategy::tolerances || strategy == Strategy::tolerances_each;
    // A single one may be more expensive than the average.
    const double most = (tolerances ? 1.5 : 1.0) * (movers == 1 ? 3.0 : 2.0);
    const double far = spacings * std::pow(static_cast<double>(n), -1.0 / d);
    for (int call = 0; call < 3; ++call) {
        std::vector<Index> index;
        std::vector<Coordinates<d>> target;
        for (std::size_t k = 0; k < movers; ++k) {
            const std::size_t i = (k * (n / movers) + static_cast<std::size_t>(call)) % n;
            Coordinates<d> way;
            double square = 0.0;
            for (double& c : way) {
                c = between(random, -1.0, 1.0);
                square += c * c;
            }
            for (std::size_t c = 0; c < d; ++c) x[i][c] += far * way[c] / std::sqrt(square);
            index.push_back(static_cast<Index>(i));
            target.push_back(x[i]);
        }
        const Move_result report = mesh.move(std::span<const Index>(index), std::span<const Coordinates<d>>(target));
        const double cost = report.statistics.cost / static_cast<double>(movers);
        CAPTURE(call, cost, report.statistics.evaluated, report.statistics.undone_flips, report.moves.flipped,
                report.moves.reinserted, report.moves.rebuilt);
        CHECK(cost < most * Cost_model<d>::reinsertion);
        CHECK(report.moves.rebuilt == 0);
        CHECK(report.statistics.tolerance_recomputations == 0);
        if (spacings > 5.0) CHECK(10 * report.moves.reinserted >= 9 * movers);
        // Facets of inverted cells have no tolerances that earlier stages could find: they are not evaluated. What the
        // exact stage decides are signs.
        if (spacings > 5.0 && movers > 1) CHECK(report.statistics.arithmetic.exact < 5 * movers);
        REQUIRE(std::equal(x.begin(), x.end(), mesh.points().begin()));
    }
    REQUIRE(mesh.audit().delaunay());
}

}  // namespace

TEST_CASE("A few vertices that go far are reinserted, and cost about that", "[deep][engine][moves]") {
    for (const Strategy strategy : {Strategy::automatic, Strategy::in_place})
        for (const double spacings : {1.0, 10.0}) {
            check_far<2>(strategy, 4000, 1, spacings);
            check_far<2>(strategy, 8000, 30, spacings);  // of 4,000 a rebuild costs as much
            check_far<3>(strategy, 4000, 1, spacings);
            check_far<3>(strategy, 4000, 30, spacings);
        }
    // Only the cost decides whether everything is rebuilt: one percent of movers does not reach it.
    check_far<3>(Strategy::automatic, 20'000, 200, 10.0);
}

TEST_CASE("A few vertices that go far are reinserted, and tolerances of nothing else are recomputed",
          "[engine][moves]") {
    for (const Strategy strategy : {Strategy::tolerances, Strategy::tolerances_each})
        for (const double spacings : {1.0, 10.0}) {
            check_far<2>(strategy, 4000, 1, spacings);
            check_far<2>(strategy, 4000, 30, spacings);
            check_far<3>(strategy, 4000, 1, spacings);
            check_far<3>(strategy, 4000, 30, spacings);
        }
    // A rebuild costs less than one percent of movers, but tolerances of everything more.
    check_far<3>(Strategy::tolerances, 20'000, 200, 10.0);
}

TEMPLATE_TEST_CASE_SIG("Moves by index of points in convex position cost some rebuilds, dimension",
                       "[engine][moves][deep]", ((int d), d), 2, 3) {
    for (const Scene scene : {Scene::sphere, Scene::moment_curve})
        for (const double pace : {1e-5, 1e-2}) {
            check_cost<d, Moving_mesh<d>>(scene, pace);
            check_cost<d, Delaunay_of<d>>(scene, pace);
        }
}

TEMPLATE_TEST_CASE_SIG("Moves by index that turn out too expensive find duplicate points as others do, dimension",
                       "[engine][moves][deep]", ((int d), d), 2, 3) {
    for (const Scene scene : {Scene::sphere, Scene::moment_curve}) {
        check_duplicate_point<d, Moving_mesh<d>>(scene);
        check_duplicate_point<d, Delaunay_of<d>>(scene);
    }
}
