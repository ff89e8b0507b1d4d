// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a benchmark: followers and which vertices fail, costs of CGAL, rounding, points that move.
#include <annulus/engine/displacement.h>
#include <apps/reproduction/cgal_costs.h>
#include <apps/reproduction/contender.h>
#include <apps/reproduction/partial_motion.h>
#include <apps/reproduction/stability.h>

#include <support/catch.h>

#include <numeric>

using namespace annulus;

TEMPLATE_TEST_CASE_SIG("A follower by the paper's filtering algorithm lists the vertices that fail, dimension", "",
                       ((int d), d), 2, 3) {
    Partial_motion_scene<d> scene(400, 0.5, 0.02, 3);
    Follower<d> dt(scene.points(), {}, Paper_choice{.in_place = false, .flips = false});
    Follower<d> ours(scene.points(), {}, std::nullopt);
    REQUIRE(dt.paper_strategy() != nullptr);
    CHECK(ours.paper_strategy() == nullptr);
    CHECK(Follower<d>(scene.points(), {}, Paper_choice::of(Strategy::relocate)).paper_strategy() == nullptr);
    std::vector<Coordinates<d>> target;
    for (int step = 0; step < 4; ++step) {
        (void)scene.next(target);
        const Move_result r = dt.move_all(target);
        CHECK(r.moves.asked == 400);
        CHECK(r.moves.reinserted == dt.paper_strategy()->failed().size());
        CHECK(r.moves.within_tolerance >= 200);
        (void)ours.move_all(target);
        CHECK(ours.audit().delaunay());
        if (d == 2) CHECK(dt.audit().delaunay());
    }
    dt.recompute_tolerances();
    const Move_result still = dt.move_all(target);
    CHECK(still.moves.within_tolerance == 400);
    CHECK(dt.paper_strategy()->failed().empty());
}

TEST_CASE("A contender switches from rebuilding when a sample stays within tolerance, and is audited") {
    Partial_motion_scene<2> scene(300, 1, 1e-4, 4);
    Contender_plan plan;
    plan.kind = Contender_plan::Kind::hybrid;
    plan.paper = Paper_choice{};
    Contender<2> contender(plan, scene.points(), 1);
    std::vector<Coordinates<2>> before = scene.points(), target;
    for (std::uint64_t step = 1; step <= 6; ++step) {
        (void)scene.next(target);
        contender.follow(step, before, target);
        before = target;
    }
    const Contender_record r = contender.finish();
    CHECK(r.switched_at == 1);
    CHECK(r.sampling_seconds > 0);
    CHECK(r.step.size() == 6);
    CHECK(r.audits == 1);
    CHECK(r.audits_failed == 0);
}

TEST_CASE("Rounding is measured against integers for every bi-cell, and operations of CGAL take longer than nothing") {
    const std::vector<Coordinates<3>> x = generate<3>(Point_family::uniform, 300, 9);
    const Moving_delaunay_3 dt = paper_triangulation<3>(x);
    const Stability_record s = measure_stability<3>(dt);
    CHECK(s.bicells > 300 * 10);
    CHECK(s.above > 0);
    CHECK(s.above < s.bicells);
    CHECK(std::accumulate(s.counts.begin(), s.counts.end(), std::uint64_t{0}) <= s.bicells);
    for (std::size_t k = 0; k < s.counts.size(); ++k) CHECK(s.median[k] <= s.most[k]);
    const Operation_record o = time_operations<3>(dt);
    CHECK(o.vertices == 30);
    CHECK(o.removal > 0);
    CHECK(o.insertion > 0);
    std::vector<Coordinates<3>> target = x;
    for (auto& p : target) p[0] += 0x1p-9;
    CHECK(time_range_insertion<3>(x) > 0);
    CHECK(time_relocation<3>(x, target) > 0);
    target[0] = x[1];
    CHECK_THROWS_AS(time_relocation<3>(x, target), Error);
}

TEST_CASE("So many points move as was said, by so much") {
    Partial_motion_scene<3> scene(1000, 0.1, 0.05, 2);
    const std::vector<Coordinates<3>> before = scene.points();
    std::vector<Coordinates<3>> target;
    CHECK(scene.next(target) == Approx(0.1 * 0.05 * scene.spacing()));
    std::size_t moved = 0;
    for (std::size_t v = 0; v < target.size(); ++v) {
        if (target[v] == before[v]) continue;
        ++moved;
        CHECK(distance_upper<3>(target[v], before[v]) == Approx(0.05 * scene.spacing()));
    }
    CHECK(moved == 100);
}
