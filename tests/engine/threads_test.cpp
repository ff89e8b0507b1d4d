// SPDX-License-Identifier: GPL-3.0-or-later
// Const members may run at the same time, with the same results as alone. ThreadSanitizer checks more than equal
// results: the target annulus-threads has these tests alone, to be built with it.
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/moving_mesh.h>
#include <annulus/voronoi.h>

#include <support/at_once.h>
#include <support/catch.h>
#include <support/motions.h>
#include <support/viewed_mesh.h>
#include "../../bench/motions/families.h"

#include <cmath>
#include <latch>
#include <thread>

using namespace annulus;
using namespace annulus::testing;

namespace {

/// The results of all const members of an object, as numbers.
template <class Moving>
std::vector<double> everything(const Moving& dt) {
    std::vector<double> said;
    const auto say = [&](auto x) { said.push_back(static_cast<double>(x)); };
    const auto say_point = [&](const typename Moving::Point& p) {
        for (const double c : p) say(c);
    };
    for (Index i = 0; i < static_cast<Index>(dt.index_bound()); ++i) {
        if (!dt.is_vertex(i)) continue;
        say(dt.handle_index(i));
        say_point(dt.position(i));
        say_point(dt.fixed_position(i));
        say(dt.tolerance(i));
        say(dt.displacement(i));
        say(dt.theta(i));
        say(dt.points()[static_cast<std::size_t>(i)][0]);
    }
    const Measures measures = dt.measure();
    say(measures.tolerance.size());
    for (const double t : measures.tolerance) say(std::isnan(t) ? -1.0 : t);  // NaN at free indices
    const Audit_result audit = dt.audit();
    say(audit.delaunay());
    say(audit.degenerate_facets);
    for (const auto& cell : dt.audit_input().cells) say(cell[0]);
    say(dt.number_of_vertices());
    say(dt.vertex_of_input().size());
    say(dt.options().seed);
    say(dt.strategy());
    say(dt.mesh().dimension());
    // CGAL's const members that change nothing.
    for (const auto& p : dt.view_points()) say_point(p);
    return said;
}

template <class Moving>
void say_the_same(Tolerance_kind kind = Tolerance_kind::certified) {
    constexpr int d = Moving::dimension_of_space;
    for (const Strategy strategy :
         {Strategy::rebuild, Strategy::relocate, Strategy::in_place, Strategy::tolerances, Strategy::tolerances_each,
          Strategy::automatic, Strategy::paper, Strategy::paper_hybrid}) {
        if (kind != Tolerance_kind::certified && strategy != Strategy::paper) continue;
        CAPTURE(name_of(strategy));
        Random random(4);
        Long_motion<d> motion(Motion_kind::walk_small, 120, random);
        Moving dt(motion.positions(), Options{.strategy = strategy, .tolerance = kind});
        for (int step = 0; step < 3; ++step) {
            (void)dt.move_all(motion.advance());
            if (step == 1) dt.remove(7);
            const auto said = at_once([&] { return everything(dt); });
            const auto alone = everything(dt);
            for (const auto& s : said) CHECK((s == alone));
        }
    }
}

}  // namespace

TEST_CASE("Const members of one object may run at the same time", "[threads]") {
    say_the_same<Viewed_mesh_2>();
    say_the_same<Viewed_mesh_2>(Tolerance_kind::floating);
}

TEST_CASE("Const members of one object in space may run at the same time", "[threads][space]") {
    say_the_same<Viewed_mesh_3>();
    say_the_same<Viewed_mesh_3>(Tolerance_kind::floating);
}

TEST_CASE("Objects of their own may be moved at the same time", "[threads]") {
    const auto run = []<class Moving>(std::type_identity<Moving>) {
        constexpr int d = Moving::dimension_of_space;
        std::vector<double> said;
        for (const Strategy strategy : {Strategy::relocate, Strategy::tolerances, Strategy::tolerances_each,
                                        Strategy::automatic, Strategy::paper_hybrid}) {
            Random random(8);
            Long_motion<d> motion(Motion_kind::walk_middle, 60, random);
            Moving dt(motion.positions(), Options{.strategy = strategy});
            for (int step = 0; step < 20; ++step) (void)dt.move_all(motion.advance());
            dt.remove(3);
            dt.insert({});
            // Not tolerances: their last digits depend on the order in which CGAL lists cells, and that on addresses.
            auto cells = dt.audit_input().cells;
            for (auto& cell : cells) std::sort(cell.begin(), cell.end());
            std::sort(cells.begin(), cells.end());
            for (const auto& cell : cells) said.insert(said.end(), cell.begin(), cell.end());
            said.push_back(dt.audit().delaunay());
        }
        return said;
    };
    const auto both = [&] {
        auto said = run(std::type_identity<Viewed_mesh_2>());
        const auto more = run(std::type_identity<Viewed_mesh_3>());
        said.insert(said.end(), more.begin(), more.end());
        return said;
    };
    const auto alone = both();
    for (const auto& s : at_once(both)) CHECK((s == alone));
}

TEST_CASE("Const members of a mesh may run at the same time", "[threads]") {
    bench::Scene<3> scene("uniform", "walk", 300, 1e-3, 1);
    for (const Strategy strategy : {Strategy::automatic, Strategy::tolerances}) {
        Options options;
        options.strategy = strategy;
        Moving_mesh<3> mesh(std::span<const Coordinates<3>>(scene.points()), options);
        for (int step = 0; step < 4; ++step) {
            scene.step();
            (void)mesh.move_all(scene.points());
        }
        const auto say = [&mesh] {
            std::vector<double> said = mesh.tolerances();
            for (std::size_t i = 0; i < mesh.index_bound(); ++i) {
                said.push_back(mesh.theta(static_cast<Index>(i)));
                said.push_back(mesh.displacement(static_cast<Index>(i)));
            }
            said.push_back(static_cast<double>(mesh.cells().vertices.size()));
            said.push_back(mesh.measure().theta_min);
            said.push_back(mesh.audit().delaunay());
            const std::vector<double> volumes = mesh.voronoi_volumes();  // the first call computes them
            said.insert(said.end(), volumes.begin(), volumes.end());
            const std::vector<double> facets = voronoi(mesh).measure;  // so does this
            said.insert(said.end(), facets.begin(), facets.end());
            return said;
        };
        const auto together = at_once(say);
        const auto alone = say();
        for (const auto& s : together) CHECK((s == alone));
    }
}
