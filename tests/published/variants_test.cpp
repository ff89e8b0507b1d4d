// SPDX-License-Identifier: GPL-3.0-or-later
// Each variant of the paper's algorithms: it is correct where its tolerances are sound, and its counts.
#include <annulus/engine/displacement.h>
#include <annulus/published/delimiter_side.h>

#include <published/paper_mesh.h>
#include <support/catch.h>

using namespace annulus;
using namespace annulus::testing;

namespace {

constexpr Paper_choice printed{.in_place = false, .flips = false};
constexpr Paper_choice relocation{.tolerances = false, .in_place = false, .flips = false};
constexpr Paper_choice with_safe_region{.in_place = false, .flips = false, .safe_region = true};

std::vector<Paper_choice> every_choice() {
    std::vector<Paper_choice> out;
    for (int bits = 0; bits < 16; ++bits)
        out.push_back({(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0, false});
    return out;
}

/// A few steps, with checks after each. `sound`: the cells must be Delaunay at the moving positions too.
template <int d>
void follow(const Paper_choice& choice, double pace, bool sound) {
    CAPTURE(d, choice.tolerances, choice.in_place, choice.flips, choice.safe_region, pace);
    Random random(3);
    std::vector<Coordinates<d>> x = random_places<d>(d == 2 ? 200 : 100, random);
    Paper_mesh<d> dt(x, choice);
    for (int step = 0; step < 4; ++step) {
        stir<d>(x, pace, random);
        const Move_result r = dt.engine.move_all(x);
        const Move_counts& m = r.moves;
        CHECK(m.asked == x.size());
        CHECK(m.within_tolerance + m.kept_in_place + m.flipped + m.reinserted + m.rebuilt == m.asked);
        CHECK(m.rebuilt == 0);
        if (!choice.tolerances)
            CHECK((r.statistics.evaluated == 0 && m.within_tolerance == 0 && r.statistics.requeued == 0));
        if (!choice.flips || d == 3) CHECK(m.flipped == 0);
        if (!choice.in_place && !(choice.flips && d == 2) && !(choice.safe_region && choice.tolerances && d == 2))
            CHECK(m.kept_in_place == 0);
        if (choice.tolerances) CHECK(dt.delaunay_at_fixed());
        if (!sound) continue;
        CHECK(dt.delaunay());
        const Paper_mesh<d> fresh(x, relocation);
        CHECK(cell_set<d>(dt.engine) == cell_set<d>(fresh.engine));
    }
}

}  // namespace

TEST_CASE("In 2D the paper's algorithms keep a triangulation right, whether moves are small or large", "[published]") {
    for (const Paper_choice& choice : every_choice())
        for (const double pace : {0.0005, 0.02, 0.5}) follow<2>(choice, pace, true);
}

TEST_CASE("In 3D they keep it right at the fixed positions, and at the moving ones if there are no tolerances",
          "[published]") {
    for (const Paper_choice& choice : every_choice())
        for (const double pace : {0.0005, 0.2}) follow<3>(choice, pace, !choice.tolerances);
}

TEST_CASE("Small moves pass by tolerances or are kept by tests in place, and neither relocates", "[published]") {
    Random random(5);
    const std::vector<Coordinates<2>> source = random_places<2>(1000, random);
    std::vector<Coordinates<2>> x = source;
    stir<2>(x, 3e-6, random);
    Paper_mesh<2> by_tolerances(source, printed), in_place(source, Paper_choice::of(Strategy::relocate_flips));
    CHECK(by_tolerances.engine.move_all(x).moves.within_tolerance > 900);
    CHECK(in_place.engine.move_all(x).moves.kept_in_place > 900);
    CHECK(by_tolerances.engine.move_all(x).moves.within_tolerance == 1000);
}

TEST_CASE("The safe region is larger than the tolerance, and moves can leave it", "[published]") {
    Random random(6);
    const std::vector<Coordinates<2>> source = random_places<2>(1000, random);
    std::vector<Coordinates<2>> x = source;
    stir<2>(x, 1e-3, random);
    Paper_mesh<2> by_tolerances(source, printed), safe(source, with_safe_region);
    const Move_result a = by_tolerances.engine.move_all(x), b = safe.engine.move_all(x);
    CHECK(b.moves.reinserted < a.moves.reinserted);
    CHECK(b.moves.reinserted > 0);
    CHECK(b.moves.kept_in_place > 0);
    CHECK(safe.delaunay());
}

TEST_CASE("In 2D a triangulation stays Delaunay while all vertices are in their safe regions", "[published]") {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Random random(seed);
        const std::vector<Coordinates<2>> x = random_places<2>(100, random);
        const Paper_mesh<2> dt(x, printed);
        const auto& table = dt.mesh.table();
        Audit_input<2> moved = dt.engine.audit_input();
        int beyond = 0;
        for (Index v = 0; v < 100; ++v) {
            const double tolerance = dt.engine.tolerance(v);
            for (int tries = 0; tries < 20; ++tries) {
                Coordinates<2> p = x[static_cast<std::size_t>(v)];
                for (double& c : p) c += 3 * tolerance * between(random, -1, 1);
                bool safe = true;
                for_each_certificate(
                    table, v, [](Corner_index) {},
                    [&](Corner_index f) {
                        safe = safe && keeps_its_side(facet_certificate(table, f, true), std::span(x), v, p);
                    });
                if (!safe) continue;
                beyond += distance_upper<2>(p, x[static_cast<std::size_t>(v)]) > tolerance ? 1 : 0;
                moved.points[static_cast<std::size_t>(v)] = p;
                break;
            }
        }
        CHECK(beyond > 30);
        CHECK(audit(moved).delaunay());
    }
}

TEST_CASE("A point keeps its side of a delimiter until it has crossed the middle circle", "[published]") {
    // The facet is a diameter of the inner circle; the delimiter is midway between the circles of a, b and of p, q.
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

TEST_CASE("Strategies of the library are variants of the paper's algorithms", "[published]") {
    for (const Strategy s : {Strategy::relocate, Strategy::relocate_flips, Strategy::paper, Strategy::paper_hybrid})
        CHECK(Paper_choice::of(s).strategy() == s);
}
