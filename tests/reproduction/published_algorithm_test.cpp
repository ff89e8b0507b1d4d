// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's algorithms as printed: correctness in 2D, counts, rounding and costs.
#include <annulus/engine/displacement.h>
#include <annulus/reproduction/delimiter_side.h>
#include <annulus/reproduction/operations.h>
#include <annulus/reproduction/partial_motion.h>
#include <annulus/reproduction/published_algorithm.h>
#include <annulus/reproduction/stability.h>

#include <support/catch.h>

#include <numeric>

using namespace annulus;

namespace {

constexpr Published_variant choices[] = {{},
                                         {.in_place = true},
                                         {.tolerances = false},
                                         {.tolerances = false, .in_place = true},
                                         {.tolerances = false, .flips = true},
                                         {.safe_region = true}};

/// A few steps of small moves, audited after each.
template <int d>
void follow(const Published_variant& choice, double pace, bool audited) {
    Partial_motion_scene<d> scene(400, 1, pace, 3);
    Published_algorithm<d> published(scene.points(), choice);
    std::vector<Coordinates<d>> target;
    for (int step = 0; step < 4; ++step) {
        (void)scene.next(target);
        const Move_report r = published.move_all(target);
        CHECK(r.moves.asked == 400);
        CHECK(r.moves.asked - r.moves.within_tolerance == published.failed().size());
        CHECK(r.moves.within_tolerance + r.moves.kept_in_place + r.moves.reinserted == r.moves.asked);
        CHECK(r.moves.flipped + r.moves.rebuilt == 0);
        if (!choice.tolerances) CHECK((r.evaluated == 0 && r.moves.within_tolerance == 0 && r.requeued == 0));
        if (choice.flips && pace < 0.01) CHECK(published.audit().delaunay());
        if (!choice.in_place && !choice.safe_region) CHECK(r.moves.kept_in_place == 0);
        if (audited) CHECK(published.audit().delaunay());
    }
}

}  // namespace

TEST_CASE("The paper's printed algorithms keep a triangulation of the plane right, whether moves are small or large") {
    for (const Published_variant& choice : choices)
        for (const double pace : {0.001, 0.05, 0.5}) follow<2>(choice, pace, true);
}

TEST_CASE("In space they do where no tolerance is believed") {
    for (const Published_variant& choice : choices)
        for (const double pace : {0.001, 0.3}) follow<3>(choice, pace, !choice.tolerances);
}

TEST_CASE("Small moves are let pass by tolerances, kept by tests in place, and relocated by neither") {
    Partial_motion_scene<2> scene(1000, 1, 1e-4, 5);
    std::vector<Coordinates<2>> target;
    (void)scene.next(target);
    Published_algorithm<2> published(scene.points(), {}),
        in_place(scene.points(), {.tolerances = false, .in_place = true});
    CHECK(published.move_all(target).moves.within_tolerance > 900);
    CHECK(in_place.move_all(target).moves.kept_in_place > 900);
    const Move_report still = published.move_all(target);
    CHECK(still.moves.within_tolerance == 1000);
    CHECK(published.failed().empty());
}

TEST_CASE("The safe region is larger than the tolerance, and not all there is") {
    Partial_motion_scene<2> scene(1000, 1, 0.02, 6);
    std::vector<Coordinates<2>> target;
    (void)scene.next(target);
    Published_algorithm<2> published(scene.points(), {}), safe(scene.points(), {.safe_region = true});
    const Move_report a = published.move_all(target), b = safe.move_all(target);
    CHECK(b.moves.reinserted < a.moves.reinserted);
    CHECK(b.moves.reinserted > 0);
    CHECK(b.moves.kept_in_place > 0);
}

TEST_CASE("Its tolerances are those of the paper's queue") {
    const std::vector<Coordinates<3>> x = generate<3>(Point_family::uniform, 300, 8);
    const Published_algorithm<3> printed(x, {});
    const Moving_delaunay_3 queue = paper_triangulation<3>(x);
    for (std::size_t v = 0; v < x.size(); ++v)
        CHECK(printed.tolerance(static_cast<Index>(v)) ==
              Approx(queue.tolerance(queue.vertex(v))).epsilon(1e-9).margin(1e-15));
    const std::vector<Coordinates<2>> y = generate<2>(Point_family::uniform, 300, 8);
    const Published_algorithm<2> plane(y, {});
    const Moving_delaunay_2 other = paper_triangulation<2>(y);
    for (std::size_t v = 0; v < y.size(); ++v)
        CHECK(plane.tolerance(static_cast<Index>(v)) ==
              Approx(other.tolerance(other.vertex(v))).epsilon(1e-9).margin(1e-15));
}

TEST_CASE("A point keeps its side of a delimiter until it has crossed the middle circle") {
    // A unit square's diagonal as the facet: the delimiter is the circle midway between those of a, b and of p, q.
    const std::vector<Coordinates<2>> x{{-1, 0}, {1, 0}, {0, -3}, {0, 3}};
    const auto sites = [](Index a, Index b, Index p, Index q) {
        return Facet_sites<2>{Site<2>(a), Site<2>(b), Site<2>(p), Site<2>(q)};
    };
    Facet_certificate<2> f{Facet_kind::empty_sphere, sites(0, 1, 2, 3)};
    CHECK(keeps_its_side(f, x, 1, {1.99, 0}));
    CHECK_FALSE(keeps_its_side(f, x, 1, {2.01, 0}));
    CHECK(keeps_its_side(f, x, 3, {0, 2.01}));
    CHECK_FALSE(keeps_its_side(f, x, 3, {0, 1.99}));
    f = {Facet_kind::slab, sites(0, 1, 3, none)};
    CHECK(keeps_its_side(f, x, 3, {7, 1.51}));
    CHECK_FALSE(keeps_its_side(f, x, 3, {7, 1.49}));
    CHECK(keeps_its_side(f, x, 0, {-1, 1.49}));
    CHECK_FALSE(keeps_its_side(f, x, 0, {-1, 1.51}));
}

TEST_CASE("Rounding is measured against integers for every bi-cell, and a removal takes longer than nothing") {
    const Moving_delaunay_3 dt = paper_triangulation<3>(generate<3>(Point_family::uniform, 300, 9));
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
