// SPDX-License-Identifier: GPL-3.0-or-later
// Tolerances in periodic boxes that move: the cells are those of signs and of a fresh build, and no vertex that stays
// within its own changes a cell.
#include <annulus/error.h>
#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/cells_of_periodic.h>
#include <support/failing_new.h>
#include <support/moving_box.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>
#include <support/safe_tolerances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

struct Met {
    std::uint64_t asked = 0, within = 0, flips = 0, rebuilt = 0, tolerance_steps = 0, recomputations = 0;
    double mean_tolerance = 0;  // in spacings
};

template <int d>
Met expect_same_cells(Moving how, int kind, std::size_t n, double step, int steps) {
    CAPTURE(d, static_cast<int>(how), kind, n, step);
    Moving_box<d> motion(how, kind, n, step);
    Periodic_cases cases(n + 7);
    Periodic_mesh<d> mesh(motion.points(), motion.box(), {.strategy = Periodic_strategy::tolerances});
    Periodic_mesh<d> signs(motion.points(), motion.box(), {.strategy = Periodic_strategy::signs});
    Periodic_mesh<d> automatic(motion.points(), motion.box());
    Met met;
    for (int k = 0; k < steps; ++k) {
        motion.advance();
        const Move_result r = mesh.move_all(motion.points(), motion.box());
        (void)signs.move_all(motion.points(), motion.box());
        (void)automatic.move_all(motion.points(), motion.box());
        const Move_counts& m = r.moves;
        CHECK(m.asked == m.within_tolerance + m.kept_in_place + m.flipped + m.rebuilt);
        met.asked += m.asked;
        met.within += m.within_tolerance;
        met.rebuilt += m.rebuilt;
        met.flips += r.statistics.flips;
        met.tolerance_steps += r.statistics.tolerance_steps;
        met.recomputations += r.statistics.tolerance_recomputations;
        const auto cells = cells_of(mesh);
        CHECK(cells == cells_of(signs));
        CHECK(cells == cells_of(automatic));
        CHECK(mesh.neighbour_counts() == signs.neighbour_counts());
        if (k % 4 == 3) {
            expect_safe_tolerances(mesh, cases);
            CHECK(mesh.audit().delaunay());
            CHECK(cells == cells_of(Periodic_mesh<d>(mesh.saved())));
        }
    }
    const double spacing = std::pow(motion.box().volume() / static_cast<double>(n), 1.0 / d);
    for (const double t : mesh.tolerances()) met.mean_tolerance += t / spacing / static_cast<double>(n);
    return met;
}

template <int d>
void expect_all_motions(std::size_t n, int steps) {
    for (const Moving how : all_moving)
        for (const double step : {1e-4, 1e-2}) {
            const Met met = expect_same_cells<d>(how, 0, n, step, steps);
            CAPTURE(d, static_cast<int>(how), step, met.within, met.asked, met.recomputations);
            if (step > 1e-3) continue;
            CHECK(met.tolerance_steps > 0);
            CHECK(met.mean_tolerance > (d == 2 ? 3e-3 : 2e-4));
            if (how == Moving::few || how == Moving::basis || how == Moving::rest) continue;
            CHECK(10 * met.within > 5 * met.asked);
            CHECK(met.recomputations <= 2);
        }
}

}  // namespace

TEST_CASE("With tolerances a periodic mesh has the cells of signs, and nothing that stays within them changes a cell",
          "[engine][periodic]") {
    expect_all_motions<2>(150, 16);
    expect_all_motions<3>(100, 8);
}

TEST_CASE("Periodic tolerances in boxes of all kinds, with few points, too", "[engine][periodic]") {
    for (int kind = 0; kind < Periodic_cases::kinds; ++kind)
        for (const std::size_t n : {1U, 2U, 3U, 7U, 40U})
            for (const Moving how : {Moving::strain, Moving::oscillation, Moving::wraps}) {
                expect_same_cells<2>(how, kind, n, 1e-3, repeats(8));
                expect_same_cells<3>(how, kind, n, 1e-3, repeats(4));
            }
}

TEST_CASE("Periodic tolerances survive hundreds of steps of strain and shear", "[engine][periodic]") {
    for (const Moving how : {Moving::strain, Moving::shear, Moving::turn}) {
        const Met plane = expect_same_cells<2>(how, 1, 60, 3e-3, 120);
        CHECK(2 * plane.within > plane.asked);
        CHECK((plane.flips > 0 || how != Moving::shear));
        const Met space = expect_same_cells<3>(how, 4, 40, 2e-4, 60);
        CHECK(4 * space.within > space.asked);
    }
}

namespace {

/// A crystal, which is cospherical everywhere while it rests, in a box that is strained and comes back.
template <int d>
void expect_crystal() {
    CAPTURE(d);
    std::vector<Coordinates<d>> rest;
    constexpr std::size_t side = 4;
    for (std::size_t k = 0; k < (d == 2 ? side * side : side * side * side); ++k) {
        Coordinates<d> p;
        for (std::size_t i = 0, left = k; i < d; ++i, left /= side) p[i] = static_cast<double>(left % side) / side;
        rest.push_back(p);
    }
    Coordinates<d> lengths;
    lengths.fill(1);
    const Box<d> box = Box<d>::orthorhombic(lengths);
    Periodic_cases cases(3);
    Periodic_mesh<d> mesh(rest, box, {.strategy = Periodic_strategy::tolerances});
    const auto expect = [&](const std::vector<Coordinates<d>>& x, const Box<d>& in) {
        (void)mesh.move_all(x, in);
        const Periodic_mesh<d> fresh(x, in);
        CHECK(cells_of(mesh) == cells_of(fresh));
        CHECK(mesh.neighbour_counts() == fresh.neighbour_counts());  // by which facets are exactly empty
        CHECK(mesh.audit().delaunay());
        expect_safe_tolerances(mesh, cases);
    };
    for (const double by : {1e-12, 0.0, 1e-3, 0.0, -1e-5, 0.0, 0.0}) {
        auto x = rest;
        for (auto& p : x) p[0] += by * p[1];
        auto sheared = box.vectors();
        sheared[1][0] = by;
        expect(x, Box<d>(sheared));
        x = rest;
        x[5][1] += by;  // one atom, in the box at rest
        expect(x, box);
        expect(rest, box);
        for (auto& p : x) p[0] += 0x1p-20;
        x[5][1] = rest[5][1];
        expect(x, box);
    }
}

/// Calls of all kinds on one object with tolerances.
template <int d>
void expect_mixed_calls() {
    CAPTURE(d);
    Periodic_cases cases(11 + d);
    Box<d> box = cases.box<d>(4);
    std::vector<Coordinates<d>> x = cases.points<d>(box, 50, 1);
    Periodic_mesh<d> mesh(x, box, {.report_changes = true, .strategy = Periodic_strategy::tolerances});
    const double spacing = std::pow(box.volume() / 50, 1.0 / d);
    for (int k = 0; k < repeats(60); ++k) {
        switch (cases.below(6)) {
            case 0:
                for (std::size_t v = 0; v < x.size(); ++v)
                    if (!mesh.is_vertex(static_cast<Index>(v))) {
                        x[static_cast<std::size_t>(mesh.saved().free_indices.back())] = cases.point<d>(box, 1);
                        mesh.insert(x[static_cast<std::size_t>(mesh.saved().free_indices.back())]);
                        break;
                    }
                break;
            case 1: {
                const auto v = static_cast<Index>(cases.below(x.size()));
                if (mesh.is_vertex(v)) mesh.remove(v);
                break;
            }
            case 2: {  // the box alone
                auto vectors = box.vectors();
                for (auto& row : vectors) row[0] *= 1 + cases.uniform(-1e-3, 1e-3);
                box = Box<d>(vectors);
                (void)mesh.move_all(x, box);
                break;
            }
            case 3: {  // refused
                auto y = x;
                y[7][0] = std::numeric_limits<double>::infinity();
                try {
                    (void)mesh.move_all(y, box);
                } catch (const Error&) {
                }
                break;
            }
            default:
                for (auto& p : x)
                    for (double& c : p) c += 1e-3 * spacing * cases.uniform(-1, 1);
                (void)mesh.move_all(x, box);
        }
        expect_safe_tolerances(mesh, cases);
        CHECK(cells_of(mesh) == cells_of(Periodic_mesh<d>(mesh.saved())));
    }
}

/// A move that runs out of memory anywhere: the same cells, and tolerances that are right, then and later.
template <int d>
void expect_starved_moves() {
    CAPTURE(d);
    Moving_box<d> motion(Moving::shear, 0, 30, 0.02);
    Periodic_cases cases(2);
    int refused = 0, kept = 0;
    for (std::uint64_t n = 0;; ++n) {
        Periodic_mesh<d> mesh(motion.points(), motion.box(), {.strategy = Periodic_strategy::tolerances});
        Moving_box<d> next = motion;
        for (int k = 0; k < 2; ++k) {
            next.advance();
            (void)mesh.move_all(next.points(), next.box());
        }
        next.advance();
        const auto before = cells_of(mesh);
        const Box<d> box = next.box();
        const Starved end = starve(n, Memory::short_once, [&] { (void)mesh.move_all(next.points(), box); });
        if (end == Starved::refused) {
            ++refused;
            CHECK(cells_of(mesh) == before);
        } else {
            ++kept;
            CHECK(cells_of(mesh) == cells_of(Periodic_mesh<d>(next.points(), box)));
        }
        expect_safe_tolerances(mesh, cases);
        for (int k = 0; k < 3; ++k) {
            (void)mesh.move_all(next.points(), next.box());
            CHECK(cells_of(mesh) == cells_of(Periodic_mesh<d>(next.points(), next.box())));
            expect_safe_tolerances(mesh, cases);
            next.advance();
        }
        if (end == Starved::done) break;
    }
    CHECK((refused > 3 && kept > 0));
}

template <int d>
void expect_same_results_for_threads() {
    CAPTURE(d);
    Moving_box<d> motion(Moving::strain, 0, 1500, 0.01);
    Periodic_mesh<d> one(motion.points(), motion.box(), {.strategy = Periodic_strategy::tolerances});
    Periodic_mesh<d> three(motion.points(), motion.box(), {.threads = 3, .strategy = Periodic_strategy::tolerances});
    for (int k = 0; k < 3; ++k) {
        motion.advance();
        CHECK(one.move_all(motion.points(), motion.box()).statistics ==
              three.move_all(motion.points(), motion.box()).statistics);
        CHECK(one.tolerances() == three.tolerances());
        CHECK(one.cells().vertices == three.cells().vertices);
    }
}

}  // namespace

namespace {

/// Material that turns under a load along fixed axes: its box is a rotation, and then the load.
template <int d>
void expect_turning_under_load(std::uint64_t seed, std::size_t n, int steps) {
    CAPTURE(d, seed, n);
    Periodic_cases cases(seed);
    const auto cube = cases.box<d>(0).vectors();
    const auto rest = cases.points<d>(Box<d>(cube), n, 1);
    const auto at = [](const Coordinates<d>& p, double angle, double load) {
        Coordinates<d> q = p;
        q[0] = (1 + load) * (std::cos(angle) * p[0] - std::sin(angle) * p[1]);
        q[1] = (1 - load) * (std::sin(angle) * p[0] + std::cos(angle) * p[1]);
        return q;
    };
    Periodic_mesh<d> mesh(rest, Box<d>(cube), {.strategy = Periodic_strategy::tolerances});
    std::uint64_t by_tolerances = 0;
    for (int k = 0; k < steps; ++k) {
        const double angle = std::max(0, k - 4) * 0.015, load = 0.005 * std::min(k, 4);
        auto vectors = cube;
        auto x = rest;
        for (auto& v : vectors) v = at(v, angle, load);
        for (auto& p : x) p = at(p, angle, load);
        by_tolerances += mesh.move_all(x, Box<d>(vectors)).statistics.tolerance_steps;
        CHECK(cells_of(mesh) == cells_of(Periodic_mesh<d>(x, Box<d>(vectors))));
    }
    CHECK(2 * by_tolerances > static_cast<std::uint64_t>(steps));
}

}  // namespace

TEST_CASE("Periodic tolerances in a box that turns under a load", "[engine][periodic]") {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        expect_turning_under_load<2>(seed, 30, 60);
        expect_turning_under_load<3>(seed, 30, 40);
    }
}

TEST_CASE("Crystals with periodic tolerances, at rest and strained and back", "[engine][periodic]") {
    expect_crystal<2>();
    expect_crystal<3>();
}

TEST_CASE("Periodic tolerances are right after calls of all kinds", "[engine][periodic]") {
    expect_mixed_calls<2>();
    expect_mixed_calls<3>();
}

TEST_CASE("Periodic tolerances are right where a move runs out of memory", "[engine][periodic]") {
    expect_starved_moves<2>();
    expect_starved_moves<3>();
}

TEST_CASE("Periodic tolerances do not depend on the number of threads", "[engine][periodic]") {
    expect_same_results_for_threads<2>();
    expect_same_results_for_threads<3>();
}
