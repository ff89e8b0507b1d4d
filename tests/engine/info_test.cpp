// SPDX-License-Identifier: GPL-3.0-or-later
// A caller's info at vertices stays with its vertex through moves, rebuilds, insertions and removals.
#include <annulus/moving_delaunay_2.h>
#include <annulus/moving_delaunay_3.h>

#include <support/cases.h>

#include <map>
#include <string>

using namespace annulus;
using namespace annulus::testing;

TEMPLATE_TEST_CASE("Info stays with its vertex", "[relocation]", Moving_delaunay_with_info_2<std::string>,
                   Moving_delaunay_with_info_3<std::string>) {
    constexpr int d = TestType::dimension_of_space;
    const auto point = [](const Coordinates<d>& p) {
        if constexpr (d == 2) return typename TestType::Point(p[0], p[1]);
        else return typename TestType::Point(p[0], p[1], p[2]);
    };
    for (const Strategy strategy :
         {Strategy::rebuild, Strategy::relocate, Strategy::relocate_flips, Strategy::in_place, Strategy::tolerances,
          Strategy::tolerances_each, Strategy::automatic, Strategy::paper, Strategy::paper_hybrid}) {
        CAPTURE(name_of(strategy));
        for_each_seed(1, [&](Random& random) {
            Options options;
            options.strategy = strategy;
            TestType dt(some_points<d>(all_sets<d>()[random() % 3], 12, 20, random), options);
            std::map<Index, std::string> name;
            std::map<Index, typename TestType::Vertex_handle> handle;
            const auto christen = [&](typename TestType::Vertex_handle v, const std::string& word) {
                v->info() = word + " with more letters than a short string holds in itself";
                name[dt.index(v)] = v->info();
                handle[dt.index(v)] = v;
            };
            const auto check = [&] {
                REQUIRE(dt.number_of_vertices() == name.size());
                for (const auto& [i, word] : name) {
                    REQUIRE(dt.vertex(static_cast<std::size_t>(i)) == handle.at(i));
                    CHECK(handle.at(i)->info() == word);
                }
            };
            for (std::size_t i = 0; i < dt.index_bound(); ++i) christen(dt.vertex(i), "vertex " + std::to_string(i));
            check();
            for (int step = 0; step < 12; ++step) {
                const double pace = std::array{0.4, 1e-3, 1e-9}[static_cast<std::size_t>(step) % 3];
                Points_of<d> x(dt.positions().begin(), dt.positions().end());
                for (auto& p : x)
                    for (double& c : p) c += pace * between(random, -1.0, 1.0);
                dt.move_all(x);
                check();
                auto some = std::next(name.begin(), static_cast<std::ptrdiff_t>(random() % name.size()));
                dt.move(some->first, Coordinates<d>{3.0 + 0.01 * step, 0.5});
                check();
                // Some insertions by CGAL's points: with indices, and in pairs with their handles.
                const std::array<Index, 1> which{some->first};
                dt.move(which, std::vector{point({4.0 + 0.01 * step, 0.5})});
                (void)dt.triangulation();  // updates what handles point to
                CHECK(handle.at(some->first)->point() == point({4.0 + 0.01 * step, 0.5}));
                const std::vector pairs{std::pair(handle.at(some->first), point({5.0 + 0.01 * step, 0.5}))};
                dt.move(pairs.begin(), pairs.end());
                (void)dt.triangulation();
                CHECK(handle.at(some->first)->point() == point({5.0 + 0.01 * step, 0.5}));
                check();
                if (step % 2 == 0) {
                    some = std::next(name.begin(), static_cast<std::ptrdiff_t>(random() % name.size()));
                    dt.remove(handle.at(some->first));
                    handle.erase(some->first);
                    name.erase(some);
                    check();
                    continue;
                }
                const auto v = dt.insert(point({-2.0 - 0.01 * step, 1.0}));
                CHECK(v->info().empty());  // of a reused index too
                christen(v, "come in step " + std::to_string(step));
                check();
            }
            dt.recompute_tolerances();
            check();
            CHECK(dt.audit().delaunay());
        });
    }
}
