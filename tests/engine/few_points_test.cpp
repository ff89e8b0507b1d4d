// SPDX-License-Identifier: GPL-3.0-or-later
// Programs of calls on few points: on a grid, exchanged, on a line, inserted and removed, under every strategy.
#include <common/operation.h>

#include <support/cases.h>

#include <cmath>
#include <iostream>

using namespace annulus;
using namespace annulus::oracle;
using namespace annulus::testing;

namespace {

template <int d>
void holds(const Program_of<d>& program) {
    const std::string fault = run_and_shrink(program);
    INFO(fault);
    REQUIRE(fault.empty());
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Points on a small grid may go anywhere and come back under any strategy, dimension",
                       "[relocation]", ((int d), d), 2, 3) {
    constexpr int side = d == 2 ? 5 : 3;
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(name_of(setting)) {
            for_each_seed(d == 2 ? 60 : 20, [&](Random& random) {
                const auto number = [&](std::size_t bound) { return static_cast<std::size_t>(random() % bound); };
                Points_of<d> grid;
                for (int i = 0; i < (d == 2 ? side * side : side * side * side); ++i) {
                    Coordinates<d> p{static_cast<double>(i % side), static_cast<double>(i / side % side)};
                    p.back() = static_cast<double>(i / (d == 2 ? side : side * side));
                    grid.push_back(p);
                }
                for (std::size_t i = grid.size(); i > 1; --i) std::swap(grid[i - 1], grid[number(i)]);
                const std::size_t n = number(20);
                Program_of<d> program{setting, {grid.begin(), grid.begin() + static_cast<std::ptrdiff_t>(n)}, {}};
                for (int step = 0; step < 12; ++step) {
                    if (number(2) == 0) {
                        program.operations.push_back(
                            Calls<d>::move(static_cast<Index>(number(n + 1)), grid[number(grid.size())]));
                    } else if (number(4) == 0) {
                        program.operations.push_back(Calls<d>::move_all(program.points));
                    } else {
                        Points_of<d> x = grid;
                        for (std::size_t i = 0; i < 1 + number(4); ++i) std::swap(x[number(n + 5)], x[number(n + 5)]);
                        x.resize(n);
                        program.operations.push_back(Calls<d>::move_all(x));
                    }
                }
                holds(program);
            });
        }
    }
}

TEMPLATE_TEST_CASE_SIG("Positions exchanged among vertices in one call are no duplicate points, dimension",
                       "[relocation]", ((int d), d), 2, 3) {
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(name_of(setting)) {
            for_each_seed(d == 2 ? 60 : 20, [&](Random& random) {
                const Points_of<d> home = some_points<d>(any_set<d>(random), 3, d == 2 ? 25 : 12, random);
                Points_of<d> rotated = home;
                std::rotate(rotated.begin(), rotated.begin() + 1, rotated.end());
                Points_of<d> swapped = home;
                std::swap(swapped[random() % home.size()], swapped[random() % home.size()]);
                Points_of<d> shuffled = home;
                shuffle(shuffled, random);
                using Do = Calls<d>;
                holds<d>({setting,
                          home,
                          {Do::move_all(rotated), Do::move_all(swapped), Do::move_all(shuffled), Do::move_all(home)}});
            });
        }
    }
}

TEMPLATE_TEST_CASE_SIG("A few points grow to many and shrink to none, dimension", "[relocation]", ((int d), d), 2, 3) {
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(name_of(setting)) {
            for_each_seed(d == 2 ? 60 : 20, [&](Random& random) {
                const Points_of<d> points = some_points<d>(any_set<d>(random), 1, 12, random);
                Program_of<d> program{setting, {}, {}};
                auto& calls = program.operations;
                for (const auto& p : points) {
                    calls.push_back(Calls<d>::insert(p));
                    calls.push_back(
                        Calls<d>::move_some(static_cast<Index>(random() % 12), points[random() % points.size()]));
                }
                for (std::size_t i = 0; i < points.size(); ++i) {
                    calls.push_back(Calls<d>::remove(static_cast<Index>(i)));
                    if (random() % 3 == 0) calls.push_back(Calls<d>::recompute_tolerances());
                }
                for (const auto& p : points) calls.push_back(Calls<d>::insert_near(p));
                holds(program);
            });
        }
    }
}

TEMPLATE_TEST_CASE_SIG("Points become collinear or coplanar and leave the line and the plane again, dimension",
                       "[relocation]", ((int d), d), 2, 3) {
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(name_of(setting)) {
            for_each_seed(d == 2 ? 60 : 20, [&](Random& random) {
                const std::size_t n = 1 + random() % 8;
                std::vector<Points_of<d>> places;
                if constexpr (d == 2) {
                    for (const Family f : {Family::collinear, Family::grid}) places.push_back(point_set(f, n, random));
                } else {
                    for (const Set_3 s : {Set_3::line, Set_3::plane, Set_3::lattice})
                        places.push_back(point_set(s, n, random));
                }
                Program_of<d> program{setting, places[0], {}};
                for (int step = 0; step < 6; ++step) {
                    const auto& target = places[random() % places.size()];
                    if (random() % 2 == 0) {
                        program.operations.push_back(Calls<d>::move_all(target));
                    } else {
                        for (std::size_t i = 0; i < n; ++i)
                            program.operations.push_back(Calls<d>::move(static_cast<Index>(i), target[i]));
                    }
                }
                holds(program);
            });
        }
    }
}
