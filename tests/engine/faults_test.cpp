// SPDX-License-Identifier: GPL-3.0-or-later
// Faults that a review found in the public class, each as a test that fails without its repair.

#include <annulus/kernel/delaunay_mesh.h>

#include <support/catch.h>
#include <support/repeats.h>
#include <support/viewed_mesh.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <memory>
#include <random>
#include <type_traits>
#include <vector>

using namespace annulus;

namespace {

template <int d>
using Moving = testing::Viewed_mesh<d>;

template <int d>
std::vector<Coordinates<d>> uniform(std::size_t n, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::vector<Coordinates<d>> x(n);
    for (auto& p : x)
        for (double& c : p) c = unit(random);
    return x;
}

Options with(Strategy strategy) {
    Options options;
    options.strategy = strategy;
    return options;
}

constexpr std::array strategies{Strategy::rebuild,   Strategy::relocate,   Strategy::relocate_flips,
                                Strategy::in_place,  Strategy::tolerances, Strategy::tolerances_each,
                                Strategy::automatic, Strategy::paper,      Strategy::paper_hybrid};

/// Limits, as a dependent name: wide ones cannot be assigned to.
template <int d>
using Horizons_of = std::conditional_t<d != 0, Limits, void>;

/// The members of a report that are compared: all but the time.
std::vector<std::uint64_t> numbers(const Move_result& r) {
    const auto& m = r.moves;
    return {m.asked,
            m.within_tolerance,
            m.kept_in_place,
            m.flipped,
            m.reinserted,
            m.rebuilt,
            r.statistics.evaluated,
            r.statistics.star_walks,
            r.statistics.flips,
            r.statistics.arithmetic.filter,
            r.statistics.arithmetic.interval,
            r.statistics.arithmetic.exact,
            r.statistics.undone_flips};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Moving everything to where it is changes nothing, whatever the strategy", "[faults]",
                       ((int d), d), 2, 3) {
    for (const Strategy strategy : strategies) {
        Moving<d> dt(std::span<const Coordinates<d>>(uniform<d>(60, 1)), with(strategy));
        const std::vector<Coordinates<d>> before(dt.points().begin(), dt.points().end());
        for (int i = 0; i < 6; ++i) dt.move_all(dt.points());  // paper-hybrid switches to `paper` here
        CHECK(std::vector<Coordinates<d>>(dt.points().begin(), dt.points().end()) == before);
        CHECK(dt.audit().delaunay());
        dt.move(0, dt.points()[0]);
        CHECK(dt.audit().delaunay());
    }
}

TEMPLATE_TEST_CASE_SIG("A time step that paper-hybrid refuses does not switch it", "[faults]", ((int d), d), 2, 3) {
    Moving<d> dt(std::span<const Coordinates<d>>(uniform<d>(60, 8)), with(Strategy::paper_hybrid));
    std::vector<Coordinates<d>> meeting(dt.points().begin(), dt.points().end());
    meeting[1] = meeting[0];
    CHECK_THROWS_AS(dt.move_all(std::span<const Coordinates<d>>(meeting)), Error);
    CHECK(dt.strategy() == Strategy::paper_hybrid);
    CHECK(dt.audit().delaunay());
    for (int i = 0; i < 8; ++i) dt.move_all(dt.points());
    CHECK(dt.strategy() == Strategy::paper);
    CHECK(dt.audit().delaunay());
}

TEMPLATE_TEST_CASE_SIG("Flips and relocations are counted as what they are", "[faults]", ((int d), d), 2, 3) {
    Moving<d> dt(std::span<const Coordinates<d>>(uniform<d>(80, 2)), with(Strategy::relocate_flips));
    // No star can follow a move across the whole set.
    Coordinates<d> far = dt.points()[0];
    for (double& c : far) c = c > 0 ? c - 1.0 : c + 1.0;
    CHECK(dt.move(0, far).moves.reinserted == 1);
    // A tiny move needs no relocation.
    Coordinates<d> near = dt.points()[1];
    near[0] += 1e-9;
    CHECK(dt.move(1, near).moves.reinserted == 0);
    CHECK(dt.audit().delaunay());
}

TEMPLATE_TEST_CASE_SIG("What stands at a free index has no say", "[faults]", ((int d), d), 2, 3) {
    const auto x = uniform<d>(60, 3);
    Moving<d> clean(std::span<const Coordinates<d>>(x), {});
    Moving<d> other(std::span<const Coordinates<d>>(x), {});
    clean.remove(7);
    other.remove(7);
    auto y = x;
    for (int step = 0; step < 20; ++step) {
        for (std::size_t i = 0; i < y.size(); ++i) y[i][0] += 1e-4 * x[i][1];
        auto junk = y;
        junk[7].fill(step % 3 == 0   ? std::numeric_limits<double>::quiet_NaN()
                     : step % 3 == 1 ? 1e300
                                     : std::numeric_limits<double>::infinity());
        CHECK(numbers(clean.move_all(std::span<const Coordinates<d>>(y))) ==
              numbers(other.move_all(std::span<const Coordinates<d>>(junk))));
        for (Index i = 0; i < static_cast<Index>(y.size()); ++i)
            if (i != 7) REQUIRE(clean.tolerance(i) == other.tolerance(i));
    }
    CHECK(other.audit().delaunay());
}

TEMPLATE_TEST_CASE_SIG("A conveyor, each vertex to the place of the next, is no heap of duplicate points", "[faults]",
                       ((int d), d), 2, 3) {
    for (const Strategy strategy : {Strategy::relocate, Strategy::in_place, Strategy::tolerances_each}) {
        const auto x = uniform<d>(d == 2 ? 1500 : 300, 4);
        Moving<d> dt(std::span<const Coordinates<d>>(x), with(strategy));
        auto y = x;
        for (std::size_t i = 0; i + 1 < x.size(); ++i) y[i] = x[i + 1];
        y.back().fill(0.125);
        const Move_result report = dt.move_all(std::span<const Coordinates<d>>(y));
        CHECK(report.moves.asked == x.size());
        CHECK(report.moves.rebuilt < x.size() / 2);  // repaired without rebuilding everything
        CHECK(dt.audit().delaunay());
    }
}

TEST_CASE("The same input gives the same run, wherever memory lies", "[faults]") {
    // Junk between the blocks that the run allocates.
    const auto run = [](std::uint64_t junk) {
        std::mt19937_64 random(junk);
        std::vector<std::unique_ptr<char[]>> held;
        for (int i = 0; i < 4000; ++i) held.push_back(std::make_unique<char[]>(random() % 9000));
        for (int i = 0; i < 3000; ++i) held[random() % held.size()].reset();
        std::vector<std::uint64_t> counts;
        const auto x = uniform<3>(400, 5);
        Moving<3> dt(std::span<const Coordinates<3>>(x), {});
        auto y = x;
        for (int step = 0; step < 12; ++step) {
            std::mt19937_64 walk(static_cast<std::uint64_t>(step));
            std::normal_distribution<double> normal;
            for (auto& p : y)
                for (double& c : p) c = std::clamp(c + 0.03 * normal(walk), -2.0, 2.0);
            for (const std::uint64_t n : numbers(dt.move_all(std::span<const Coordinates<3>>(y)))) counts.push_back(n);
        }
        for (Index i = 0; i < 40; ++i) dt.remove(9 * i);
        for (Index i = 0; i < 400; ++i)
            if (dt.is_vertex(i)) counts.push_back(std::bit_cast<std::uint64_t>(dt.tolerance(i)));
        return counts;
    };
    const auto first = run(0);
    for (int junk = 1; junk <= repeats(5); ++junk) CHECK(run(static_cast<std::uint64_t>(junk)) == first);
}

TEMPLATE_TEST_CASE_SIG("More cells than indices can name are refused, and nothing has changed", "[faults][limits]",
                       ((int d), d), 2, 3) {
    if constexpr (!Limits::tiny) {
        SUCCEED("2^29 cells are more than a test has memory for; the build with tiny limits passes this bound");
    } else {
        const std::int32_t wide = Horizons_of<d>::cells;
        for (const Strategy strategy : {Strategy::tolerances, Strategy::tolerances_each}) {
            Moving<d> dt(std::span<const Coordinates<d>>(uniform<d>(30, 6)), with(strategy));
            Horizons_of<d>::cells = dt.mesh().table().cell_bound().value();
            CHECK_THROWS_AS((Moving<d>(std::span<const Coordinates<d>>(uniform<d>(60, 7)), with(strategy))), Error);
            int refused = 0;
            for (unsigned i = 0; i < 20; ++i) {
                const auto x = uniform<d>(dt.index_bound() + 1, 100 + i);
                const std::vector<Coordinates<d>> before(dt.points().begin(), dt.points().end());
                try {
                    if (i % 2 == 0) dt.insert(x.back());
                    else dt.move_all(std::span(x).first(dt.index_bound()));
                } catch (const Error& e) {
                    CHECK(e.code() == Error_code::too_large);
                    CHECK(std::vector<Coordinates<d>>(dt.points().begin(), dt.points().end()) == before);
                    ++refused;
                }
                CHECK(dt.audit().delaunay());
                CHECK(dt.number_of_vertices() == dt.points().size());
            }
            CHECK(refused >= 5);
            Horizons_of<d>::cells = wide;
        }
    }
}
