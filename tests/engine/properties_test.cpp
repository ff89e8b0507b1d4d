// SPDX-License-Identifier: GPL-3.0-or-later
// Properties that relate two runs, and the reports of calls, in 2D and in 3D alike.
#include <annulus/arithmetic/limits.h>

#include <support/cases.h>
#include <support/checked_mesh.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>

using namespace annulus;
using namespace annulus::oracle;
using namespace annulus::testing;

namespace {

template <int d>
using Moving_of = Viewed_mesh<d>;

/// The relative difference of tolerances that are the same but for rounding. With expiries of few bits it is coarse.
constexpr double closeness = Limits::tiny ? 0.25 : 0x1p-8;

/// A fault of the session as a failed assertion.
template <class Body>
void without_fault(Body body) {
    try {
        body();
    } catch (const Session_fault& fault) {
        FAIL(fault.words);
    }
}

template <int d>
bool distinct(const Points_of<d>& x) {
    return std::set<Coordinates<d>>(x.begin(), x.end()).size() == x.size();
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Moving one by one and moving all at once end in the same cells, dimension", "[relocation]",
                       ((int d), d), 2, 3) {
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(name_of(setting)) {
            for_each_seed(d == 2 ? 60 : 15, [&](Random& random) {
                const Set_of<d> set = any_set<d>(random);
                const Points_of<d> home = some_points<d>(set, 1, d == 2 ? 30 : 15, random);
                const Points_of<d> target = point_set(set, home.size(), random);
                without_fault([&] {
                    Checked_mesh<d> at_once(Program_of<d>{setting, home, {}});
                    Checked_mesh<d> one_by_one(Program_of<d>{setting, home, {}});
                    at_once.apply(Calls<d>::move_all(target));
                    std::vector<std::size_t> order(target.size());
                    std::iota(order.begin(), order.end(), std::size_t{0});
                    shuffle(order, random);
                    for (int round = 0; round < 2; ++round)  // the second for vertices whose target was occupied
                        for (const std::size_t i : order)
                            one_by_one.apply(Calls<d>::move(static_cast<Index>(i), target[i]));
                    if (one_by_one.sites() != at_once.sites()) return;
                    at_once.check();
                    one_by_one.check();
                    CHECK(cells_of(one_by_one.dt()) == cells_of(at_once.dt()));
                });
            });
        }
    }
}

TEMPLATE_TEST_CASE_SIG("Scaling by a power of two scales the tolerances and changes nothing else, dimension",
                       "[relocation]", ((int d), d), 2, 3) {
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(name_of(setting)) {
            for_each_seed(d == 2 ? 60 : 15, [&](Random& random) {
                const Set_of<d> set = ordinary_set<d>(random);
                const Points_of<d> home = some_points<d>(set, 3, d == 2 ? 25 : 15, random);
                const double scale = std::ldexp(1.0, integer(random, -60, 60));
                const auto scaled = [scale](Points_of<d> x) {
                    for (auto& p : x)
                        for (double& c : p) c *= scale;
                    return x;
                };
                Moving_of<d> one(home, options_of(setting));
                Moving_of<d> other(scaled(home), options_of(setting));
                for (int step = 0; step < 3; ++step) {
                    Points_of<d> target = point_set(set, home.size(), random);
                    if (step == 1) {  // a short way
                        target.assign(one.points().begin(), one.points().end());
                        for (auto& p : target)
                            for (double& c : p) c += c * between(random, -0x1p-12, 0x1p-12);
                        if (!distinct<d>(target)) continue;
                    }
                    const Move_result a = one.move_all(target);
                    const Move_result b = other.move_all(scaled(target));
                    if (d == 2) {
                        CHECK(a.moves == b.moves);
                        CHECK(a.statistics.evaluated == b.statistics.evaluated);
                        CHECK(a.statistics.flips == b.statistics.flips);
                    } else {
                        // The order in which CGAL lists the cells around a vertex, and so the order of flips, depends
                        // on addresses.
                        CHECK(a.moves.within_tolerance == b.moves.within_tolerance);
                        one.recompute_tolerances();
                        other.recompute_tolerances();
                    }
                    CHECK(cells_of(one) == cells_of(other));
                    for (std::size_t i = 0; i < target.size(); ++i) {
                        const double s = one.tolerance(static_cast<Index>(i));
                        CHECK(std::fabs(s * scale - other.tolerance(static_cast<Index>(i))) <= closeness * s * scale);
                    }
                }
            });
        }
    }
}

TEMPLATE_TEST_CASE_SIG("The order of the input changes nothing but the names, dimension", "[relocation]", ((int d), d),
                       2, 3) {
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(name_of(setting)) {
            for_each_seed(d == 2 ? 60 : 15, [&](Random& random) {
                const Set_of<d> set = any_set<d>(random);
                const Points_of<d> home = some_points<d>(set, 1, d == 2 ? 25 : 12, random);
                const std::size_t n = home.size();
                std::vector<std::size_t> name(n);  // index of the i-th in the other order
                std::iota(name.begin(), name.end(), std::size_t{0});
                shuffle(name, random);
                const auto renamed = [&](const Points_of<d>& x) {
                    Points_of<d> y(n);
                    for (std::size_t i = 0; i < n; ++i) y[name[i]] = x[i];
                    return y;
                };
                Moving_of<d> one(home, options_of(setting));
                Moving_of<d> other(renamed(home), options_of(setting));
                for (int step = 0; step < 2; ++step) {
                    const Points_of<d> target = point_set(set, n, random);
                    one.move_all(target);
                    other.move_all(renamed(target));
                    Cells_of<d> expected = cells_of(one);
                    for (auto& cell : expected) {
                        for (Index& v : cell)
                            if (v != none) v = static_cast<Index>(name[static_cast<std::size_t>(v)]);
                        cell = canonical(cell);
                    }
                    std::sort(expected.begin(), expected.end());
                    CHECK(cells_of(other) == expected);
                    one.recompute_tolerances();
                    other.recompute_tolerances();
                    for (std::size_t i = 0; i < n; ++i) {
                        const double s = one.tolerance(static_cast<Index>(i));
                        CHECK(std::fabs(s - other.tolerance(static_cast<Index>(name[i]))) <= closeness * s + 0x1p-1070);
                    }
                }
            });
        }
    }
}

TEMPLATE_TEST_CASE_SIG("Reported changes are the cells that came and those that went, dimension", "[relocation]",
                       ((int d), d), 2, 3) {
    constexpr auto corners = static_cast<std::size_t>(d + 1);
    for (const Setting& setting : certified_settings) {
        DYNAMIC_SECTION(name_of(setting)) {
            for_each_seed(d == 2 ? 60 : 15, [&](Random& random) {
                const bool degenerate = random() % 2 == 0;
                Options options = options_of(setting);
                options.report_changes = true;
                Moving_of<d> dt(
                    some_points<d>(degenerate ? any_set<d>(random) : all_sets<d>()[0], d + 2, d == 2 ? 25 : 15, random),
                    options);
                for (int step = 0; step < 8; ++step) {
                    const Cells_of<d> before = cells_of(dt);
                    Move_result report;
                    Operation_of<d> shake =
                        Calls<d>::steady(Motion::jitter, 1, std::ldexp(1.0, -integer(random, 2, 9)), random());
                    Sites_of<d> now(dt.index_bound());
                    for (std::size_t i = 0; i < now.size(); ++i)
                        if (dt.is_vertex(static_cast<Index>(i))) now[i] = dt.points()[i];
                    const Points_of<d> x = next_positions<d>(shake, 0, now, now, {});
                    std::size_t v = random() % now.size();
                    while (!now[v]) v = (v + 1) % now.size();
                    if (step % 4 == 0) report = dt.move_all(x);
                    if (step % 4 == 1) report = dt.move(static_cast<Index>(v), x[v]);
                    if (step % 4 == 2) dt.remove(static_cast<Index>(v), &report);
                    if (step % 4 == 3) dt.insert(free_place<d>(x[v], now, none), &report);
                    const Cells_of<d> after = cells_of(dt);
                    const auto finite = [&](const std::vector<Index>& list) {
                        REQUIRE(list.size() % corners == 0);
                        std::set<std::array<Index, corners>> cells;
                        for (std::size_t k = 0; k < list.size(); k += corners) {
                            std::array<Index, corners> cell{};
                            std::copy_n(list.begin() + static_cast<std::ptrdiff_t>(k), corners, cell.begin());
                            if (std::find(cell.begin(), cell.end(), infinite) == cell.end())
                                CHECK(cells.insert(canonical(cell)).second);
                        }
                        return cells;
                    };
                    const auto only = [&](const Cells_of<d>& here, const Cells_of<d>& there) {
                        std::set<std::array<Index, corners>> cells;
                        std::set_difference(here.begin(), here.end(), there.begin(), there.end(),
                                            std::inserter(cells, cells.end()));
                        return cells;
                    };
                    // For a flat set, before or after, everything is listed.
                    const auto flat = [](const Cells_of<d>& cells) {
                        return cells.empty() || cells[0][d] == none || cells[0][0] == none;
                    };
                    const bool all = flat(before) || flat(after);
                    auto came = finite(report.changed), gone = finite(report.gone);
                    // Compared without orientation: cells that were only reversed are in both lists.
                    if (d == 3 && !all)
                        for (const auto& cell : std::set(came))
                            if (gone.erase(cell) == 1) came.erase(cell);
                    CHECK(came == only(after, all ? Cells_of<d>() : before));
                    CHECK(gone == only(before, all ? Cells_of<d>() : after));
                }
            });
        }
    }
}

TEMPLATE_TEST_CASE_SIG("Equal input points are merged on request, dimension", "[relocation]", ((int d), d), 2, 3) {
    for_each_seed(40, [](Random& random) {
        Points_of<d> points = some_points<d>(any_set<d>(random), 4, 30, random);
        for (std::size_t i = 3; i < points.size(); ++i)
            if (random() % 5 == 0) points[i] = points[random() % i];
        const Setting setting = certified_settings[random() % certified_settings.size()];
        Options options = options_of(setting);
        options.merge_duplicates = true;
        Moving_of<d> dt(points, options);
        const std::set<Coordinates<d>> distinct_ones(points.begin(), points.end());
        CHECK(dt.number_of_vertices() == distinct_ones.size());
        REQUIRE(dt.vertex_of_input().size() == points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            CHECK(dt.view_point(dt.vertex_of_input()[i]) == points[i]);
        }
        CHECK(dt.audit().delaunay());
        // Each index is one vertex, from 0 on in the order in which positions first appear.
        Index next = 0;
        for (const Index i : dt.vertex_of_input()) {
            CHECK(i <= next);
            if (i == next) ++next;
        }
        CHECK(static_cast<std::size_t>(next) == dt.index_bound());
        Points_of<d> own(dt.points().begin(), dt.points().end());
        CHECK(dt.move_all(own).moves.asked == own.size());
    });
}
