// SPDX-License-Identifier: GPL-3.0-or-later
// Whole programs of calls on point sets of every family: after each call the audit, CGAL and a rebuild must agree.
#include "../../fuzz/common/program.h"

#include <rapidcheck.h>
#include <support/arbitrary.h>
#include <catch2/catch.hpp>

using namespace annulus;
using namespace annulus::oracle;
using annulus::testing::Family;
using annulus::testing::Random;

namespace {

Position random_place(Family family, Random& random) {
    // Three points, not one: some families need them to be what they are.
    return annulus::testing::point_set(family, 3, random)[random() % 3];
}

/// Moves between the places of a pool that is used again and again, so that vertices return and meet.
Program program_of(Setting setting, Family family, std::uint64_t seed, int most, int calls) {
    Random random(seed);
    const auto number = [&](std::size_t bound) { return static_cast<std::size_t>(random() % bound); };
    const auto n = static_cast<std::size_t>(annulus::testing::integer(random, 0, most));
    std::vector<Position> pool = annulus::testing::point_set(family, n + n / 2 + 3, random);
    if (number(4) == 0) pool.push_back(random_place(family, random));  // may be one that is there
    Program program{setting, {pool.begin(), pool.begin() + static_cast<std::ptrdiff_t>(n)}, {}};
    std::size_t bound = n;
    const auto place = [&] { return pool[number(pool.size())]; };
    const auto near = [&](Position p) {
        for (double& c : p) {
            const double other = pool[number(pool.size())][0];
            c += (other - c) * std::ldexp(1.0, -static_cast<int>(number(60)));
        }
        return p;
    };
    for (int call = 0; call < calls; ++call) {
        switch (number(10)) {
            case 0:
            case 1: program.operations.push_back(move(static_cast<Index>(number(bound + 1)), place())); break;
            case 2: {
                const std::size_t v = number(bound + 1);
                program.operations.push_back(move(static_cast<Index>(v), near(v < n ? pool[v] : place())));
                break;
            }
            case 3:
            case 4: {  // all take distinct places of the pool
                std::vector<Position> x = pool;
                for (std::size_t i = x.size(); i > 1; --i) std::swap(x[i - 1], x[number(i)]);
                if (x.size() < bound) x = annulus::testing::point_set(family, bound, random);
                x.resize(bound);
                program.operations.push_back(move_all(x));
                break;
            }
            case 5:
            case 6: {  // all go home, some a little off
                std::vector<Position> x = pool;
                if (x.size() < bound) x = annulus::testing::point_set(family, bound, random);
                x.resize(bound);
                for (Position& p : x)
                    if (number(3) == 0) p = near(p);
                program.operations.push_back(move_all(x));
                break;
            }
            case 7:
                program.operations.push_back(insert(place()));
                ++bound;
                break;
            case 8: program.operations.push_back(remove(static_cast<Index>(number(bound + 1)))); break;
            default: program.operations.push_back(settle()); break;
        }
    }
    return program;
}

void survives(const Setting& setting, int most, int calls) {
    REQUIRE(rc::check([=] {
        const Family family =
            annulus::testing::all_families[*rc::gen::inRange<std::size_t>(0, annulus::testing::all_families.size())];
        const Program program = program_of(setting, family, *annulus::testing::seeds(), most, calls);
        const std::string fault = run(program);
        if (!fault.empty()) RC_FAIL(fault + "\n" + as_code(program));
    }));
}

std::string title(const Setting& s) {
    return std::string(name_of(s.strategy)) + ", second look " + name_as_code(s.second_look);
}

}  // namespace

TEST_CASE("After any calls under any strategy the audit passes and the cells are those of a rebuild", "[relocation]") {
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(title(setting)) {
            survives(setting, 9, 20);
            survives(setting, 40, 8);
        }
    }
}

TEST_CASE("Points on a small grid may go anywhere and come back under any strategy", "[relocation]") {
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(title(setting)) {
            REQUIRE(rc::check([setting] {
                Random random(*annulus::testing::seeds());
                const auto number = [&](std::size_t bound) { return static_cast<std::size_t>(random() % bound); };
                std::vector<Position> grid;
                for (int i = 0; i < 25; ++i) grid.push_back({static_cast<double>(i % 5), static_cast<double>(i / 5)});
                for (std::size_t i = grid.size(); i > 1; --i) std::swap(grid[i - 1], grid[number(i)]);
                const std::size_t n = number(20);
                Program program{setting, {grid.begin(), grid.begin() + static_cast<std::ptrdiff_t>(n)}, {}};
                for (int step = 0; step < 12; ++step) {
                    if (number(2) == 0) {
                        program.operations.push_back(move(static_cast<Index>(number(n + 1)), grid[number(25)]));
                    } else if (number(4) == 0) {
                        program.operations.push_back(move_all(program.points));
                    } else {
                        std::vector<Position> x = grid;
                        for (std::size_t i = 0; i < 1 + number(4); ++i) std::swap(x[number(25)], x[number(25)]);
                        x.resize(n);
                        program.operations.push_back(move_all(x));
                    }
                }
                const std::string fault = run(program);
                if (!fault.empty()) RC_FAIL(fault + "\n" + as_code(program));
            }));
        }
    }
}

TEST_CASE("A grid that moves and returns a hundred times is still Delaunay", "[relocation]") {
    std::vector<Position> home;
    for (int i = 0; i < 49; ++i) home.push_back({static_cast<double>(i % 7), static_cast<double>(i / 7)});
    for (const Setting& setting : certified_settings) {
        CAPTURE(title(setting));
        Session session(Program{setting, home, {}});
        Random random(7);
        for (int step = 0; step < 100; ++step) {
            std::vector<Position> away = home;
            for (Position& p : away)
                for (double& c : p)
                    if (random() % 2 == 0) c += std::ldexp(annulus::testing::between(random, -0.4, 0.4), -step % 50);
            session.apply(move_all(away));
            if (step % 9 == 0) session.check();
            session.apply(move_all(home));
            if (step % 9 == 0) session.check();
        }
        session.check();
        session.apply(settle());
        session.check_settled_tolerances();
    }
}

TEST_CASE("Positions exchanged among vertices in one call are no collision", "[relocation]") {
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(title(setting)) {
            REQUIRE(rc::check([setting] {
                const auto set = *annulus::testing::point_set_case(3, 25);
                Random random(set.seed + 1);
                const std::size_t n = set.points.size();
                std::vector<Position> rotated = set.points;
                std::rotate(rotated.begin(), rotated.begin() + 1, rotated.end());
                std::vector<Position> swapped = set.points;
                std::swap(swapped[random() % n], swapped[random() % n]);
                std::vector<Position> shuffled = set.points;
                for (std::size_t i = n; i > 1; --i) std::swap(shuffled[i - 1], shuffled[random() % i]);
                const Program program{setting,
                                      set.points,
                                      {move_all(rotated), move_all(swapped), move_all(shuffled), move_all(set.points)}};
                const std::string fault = run(program);
                if (!fault.empty()) RC_FAIL(fault + "\n" + as_code(program));
            }));
        }
    }
}

TEST_CASE("A few points grow to many and shrink to none", "[relocation]") {
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(title(setting)) {
            REQUIRE(rc::check([setting] {
                const auto set = *annulus::testing::point_set_case(1, 12);
                Random random(set.seed + 1);
                Program program{setting, {}, {}};
                for (const Position& p : set.points) {
                    program.operations.push_back(insert(p));
                    program.operations.push_back(move(static_cast<Index>(random() % set.points.size()),
                                                      set.points[random() % set.points.size()]));
                }
                for (std::size_t i = 0; i < set.points.size(); ++i) {
                    program.operations.push_back(remove(static_cast<Index>(i)));
                    if (random() % 3 == 0) program.operations.push_back(settle());
                }
                for (const Position& p : set.points) program.operations.push_back(insert(p));
                const std::string fault = run(program);
                if (!fault.empty()) RC_FAIL(fault + "\n" + as_code(program));
            }));
        }
    }
}

TEST_CASE("Points become collinear and leave the line again", "[relocation]") {
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(title(setting)) {
            REQUIRE(rc::check([setting] {
                Random random(*annulus::testing::seeds());
                const std::size_t n = 1 + random() % 8;
                const std::vector<Position> line = annulus::testing::point_set(Family::collinear, n, random);
                const std::vector<Position> solid = annulus::testing::point_set(Family::grid, n, random);
                Program program{setting, line, {}};
                for (int step = 0; step < 6; ++step) {
                    const auto& target = random() % 2 == 0 ? line : solid;
                    if (random() % 2 == 0) {
                        program.operations.push_back(move_all(target));
                    } else {
                        for (std::size_t i = 0; i < n; ++i)
                            program.operations.push_back(move(static_cast<Index>(i), target[i]));
                    }
                }
                const std::string fault = run(program);
                if (!fault.empty()) RC_FAIL(fault + "\n" + as_code(program));
            }));
        }
    }
}

TEST_CASE("A failed call leaves everything as it was, with the right code", "[relocation]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    const double beyond = std::nextafter(0x1p500, inf);
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(title(setting)) {
            REQUIRE(rc::check([=] {
                const auto set = *annulus::testing::point_set_case(2, 20);
                Random random(set.seed + 1);
                const std::size_t n = set.points.size();
                const auto v = static_cast<Index>(random() % n);
                const auto w = (static_cast<std::size_t>(v) + 1) % n;
                // A drift first, so that fixed positions and tolerances are not those of a settled object.
                std::vector<Position> drifted = annulus::testing::point_set(set.family, n, random);
                Program program{setting, set.points, {move_all(drifted)}};
                auto& calls = program.operations;
                for (const double bad : {nan, inf, -inf, beyond, -beyond, 0x1p1023}) {
                    calls.push_back(move(v, {bad, 0}));
                    calls.push_back(insert({0, bad}));
                    std::vector<Position> x = drifted;
                    x[w][1] = bad;
                    calls.push_back(move_all(x));
                }
                calls.push_back(move(v, drifted[w]));
                calls.push_back(insert(drifted[w]));
                std::vector<Position> meeting = drifted;
                meeting[static_cast<std::size_t>(v)] = drifted[w];
                calls.push_back(move_all(meeting));
                std::vector<Position> elsewhere = set.points;
                elsewhere[static_cast<std::size_t>(v)] = set.points[w];
                calls.push_back(move_all(elsewhere));
                for (const Index unknown : {-1, static_cast<Index>(n), 1000000, -2000000000})
                    calls.push_back(move(unknown, {0, 0}));
                calls.push_back(remove(static_cast<Index>(n)));
                std::vector<Position> longer = drifted;
                longer.push_back({0.5, 0.25});
                calls.push_back(move_all(longer));
                calls.push_back(move_all({drifted.begin(), drifted.end() - 1}));
                calls.push_back(remove(v));
                calls.push_back(move(v, {0, 0}));  // vacant now
                calls.push_back(move_all(set.points));
                calls.push_back(settle());
                const std::string fault = run(program);
                if (!fault.empty()) RC_FAIL(fault + "\n" + as_code(program));
            }));
        }
    }
}

TEST_CASE("Equal input points are refused, or merged on request", "[relocation]") {
    REQUIRE(rc::check([] {
        const auto set = *annulus::testing::point_set_case(4, 40, true);
        Options options;
        options.merge_duplicates = true;
        const Moving_delaunay_2 dt(set.points, options);
        const std::set<Position> distinct(set.points.begin(), set.points.end());
        RC_ASSERT(dt.number_of_vertices() == distinct.size());
        RC_ASSERT(dt.index_of_input().size() == set.points.size());
        for (std::size_t i = 0; i < set.points.size(); ++i) {
            const auto v = dt.vertex(static_cast<std::size_t>(dt.index_of_input()[i]));
            RC_ASSERT((Position{v->point().x(), v->point().y()} == set.points[i]));
        }
        RC_ASSERT(dt.audit().delaunay());
        // Program's constructor check knows whether there are duplicates.
        for (const Setting& setting : certified_settings) RC_ASSERT(run({setting, set.points, {}}) == "");
    }));
}

TEST_CASE("A null handle, the vertex at infinity and a stranger name no vertex", "[relocation]") {
    const Moving_delaunay_2 other(std::vector<Position>{{0, 0}, {1, 0}, {0, 1}, {5, 5}});
    for (const Setting& setting : certified_settings) {
        CAPTURE(title(setting));
        Options options;
        options.strategy = setting.strategy;
        Moving_delaunay_2 dt(std::vector<Position>{{0, 0}, {1, 0}, {0, 1}}, options);
        const auto code_of = [](auto call) {
            try {
                call();
            } catch (const Error& e) {
                return e.code();
            }
            return Error_code::usage;
        };
        // Of the strangers one has an index that this triangulation has too.
        for (const auto v : {Moving_delaunay_2::Vertex_handle(), dt.triangulation().infinite_vertex(), other.vertex(1),
                             other.vertex(3)}) {
            CHECK(code_of([&] { dt.move(v, {2, 2}); }) == Error_code::unknown_vertex);
            CHECK(code_of([&] { dt.remove(v); }) == Error_code::unknown_vertex);
            CHECK(code_of([&] { (void)dt.index(v); }) == Error_code::unknown_vertex);
            CHECK(code_of([&] { (void)dt.position(v); }) == Error_code::unknown_vertex);
            CHECK(code_of([&] { (void)dt.fixed_position(v); }) == Error_code::unknown_vertex);
            CHECK(code_of([&] { (void)dt.displacement(v); }) == Error_code::unknown_vertex);
            CHECK(code_of([&] { (void)dt.tolerance(v); }) == Error_code::unknown_vertex);
            CHECK(code_of([&] { (void)dt.theta(v); }) == Error_code::unknown_vertex);
        }
        CHECK(code_of([&] { (void)dt.vertex(3); }) == Error_code::unknown_vertex);
        CHECK(dt.audit().delaunay());
    }
}

TEST_CASE("Tolerances that may be wrong give no crash, and filter-each keeps CGAL's object valid", "[relocation]") {
    for (const Strategy strategy : {Strategy::filter, Strategy::filter_each})
        for (const Tolerance_kind kind : {Tolerance_kind::floating, Tolerance_kind::paper}) {
            DYNAMIC_SECTION(name_of(strategy) << ", " << name_of(kind)) {
                survives({strategy, Second_look::off, kind}, 12, 16);
            }
        }
}

TEST_CASE("Reported changes are the cells that were not there before", "[relocation]") {
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(title(setting)) {
            REQUIRE(rc::check([setting] {
                const auto set = *annulus::testing::point_set_case(Family::uniform, 4, 25);
                Random random(set.seed + 1);
                Options options;
                options.strategy = setting.strategy;
                options.second_look = setting.second_look;
                options.report_changes = true;
                Moving_delaunay_2 dt(set.points, options);
                for (int step = 0; step < 4; ++step) {
                    const Cells before = cells_of(dt.triangulation());
                    std::vector<Position> x(dt.positions().begin(), dt.positions().end());
                    for (Position& p : x)
                        for (double& c : p) c += annulus::testing::between(random, -0.1, 0.1);
                    const auto v = static_cast<Index>(random() % x.size());
                    Move_report report = step % 2 == 0 ? dt.move_all(x) : dt.move(v, x[static_cast<std::size_t>(v)]);
                    std::set<Cell> listed;
                    RC_ASSERT(report.changed.size() % 3 == 0);
                    for (std::size_t k = 0; k + 2 < report.changed.size(); k += 3)
                        listed.insert(canonical({report.changed[k], report.changed[k + 1], report.changed[k + 2]}));
                    const Cells after = cells_of(dt.triangulation());
                    for (const Cell& cell : after)
                        if (!std::binary_search(before.begin(), before.end(), cell)) RC_ASSERT(listed.count(cell) == 1);
                }
            }));
        }
    }
}
