// SPDX-License-Identifier: GPL-3.0-or-later
// Walks that begin at landmarks are short for any number of vertices, and end in the cell that contains the position.
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/mesh/landmarks.h>
#include <annulus/mesh/walk.h>
#include <annulus/predicate/sure_orientation.h>

#include <support/failing_new.h>
#include <support/generators.h>
#include <support/meshes.h>

#include <support/catch.h>

#include <cstdint>
#include <set>
#include <string>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
Coordinates<d> place(const std::string& family, Random& random) {
    Coordinates<d> p;
    for (double& c : p) c = between(random, 0.0, 1.0);
    if (family == "strip")
        for (std::size_t k = 1; k < d; ++k) p[k] *= 1e-3;
    if (family == "leaning strip")
        for (std::size_t k = 1; k < d; ++k) p[k] = p[0] + 1e-3 * p[k];
    if (family == "wall" && random() % 10 != 0) p[0] = 0.5;
    if (family == "cluster" && random() % 10 != 0)
        for (double& c : p) c = 0.3 + 1e-4 * c;
    if (family == "lattice")
        for (double& c : p) c = std::floor(c * (d == 2 ? 512 : 64));
    return p;
}

/// Facets crossed per walk to positions of the same family, in the last half of so many walks.
template <int d>
double steps_of(const std::string& family, std::size_t vertices) {
    Random random(3);
    std::set<Coordinates<d>> distinct;
    while (distinct.size() < vertices) distinct.insert(place<d>(family, random));
    const Points_d<d> x(distinct.begin(), distinct.end());  // a regular order, with which a stride would coincide
    Delaunay_mesh<d> mesh;
    mesh.build(std::span<const Coordinates<d>>(x));
    const Corner_table<d>& t = mesh.table();
    Landmarks<d> landmarks;
    constexpr int walks = 4000;
    double sum = 0.0;
    for (int k = 0; k < walks; ++k) {
        const Coordinates<d> p = place<d>(family, random);
        const Index near = landmarks.near(x, x.size(), p, none, [](Index) { return true; });
        std::size_t steps = 0;
        const Cell_index c = walk_to<d>(Table_walker<d>(t, x), p,
                                        t.cell_of(near == none ? t.corner_of_infinity() : t.corner_of(near)), steps);
        if (k >= walks / 2) sum += static_cast<double>(steps);
        const int i = t.slot_of_infinity(c);
        Cell_sites<d> v = cell_sites(t, c);
        if (i >= 0) {
            v[static_cast<std::size_t>(i)] = v[i == 0 ? 1 : 0];
            Tuple<d, d + 1> y = tuple<d, d + 1>(v, std::span<const Coordinates<d>>(x));
            y[static_cast<std::size_t>(i)] = &p;
            REQUIRE(sure_orientation<d>(y) > 0);
        } else {
            for (std::size_t s = 0; s <= d; ++s) {
                Tuple<d, d + 1> y = tuple<d, d + 1>(v, std::span<const Coordinates<d>>(x));
                y[s] = &p;
                REQUIRE(sure_orientation<d>(y) >= 0);
            }
        }
        landmarks.note(v[0].vertex, steps);
    }
    return sum / (walks / 2);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Walks are short whatever the number of vertices, dimension", "[landmarks][cost]", ((int d), d),
                       2, 3) {
    const char* const family = GENERATE("uniform", "strip", "leaning strip", "wall", "cluster", "lattice");
    CAPTURE(family);
    const double few = steps_of<d>(family, 1000);
    const double many = steps_of<d>(family, d == 2 ? 64000 : 16000);
    CAPTURE(few, many);
    CHECK(few < (d == 2 ? 16.0 : 24.0));
    CHECK(many < (d == 2 ? 16.0 : 24.0));
}

TEMPLATE_TEST_CASE_SIG("Insertions and moves to places far away walk a few facets, dimension", "[landmarks][cost]",
                       ((int d), d), 2, 3) {
    Random random(9);
    const std::size_t many = d == 2 ? 64000 : 16000;
    constexpr std::size_t calls = 2000;
    Points_d<d> home;
    while (home.size() < many) home.push_back(place<d>("uniform", random));
    Delaunay_mesh<d> mesh;
    mesh.build(std::span<const Coordinates<d>>(home));
    home.resize(many + 2 * calls);
    std::vector<Cell_index> changed;
    const auto insert_some = [&] {
        for (std::size_t k = 0; k < calls; ++k)
            REQUIRE(mesh.insert(home, static_cast<Index>(mesh.vertex_bound()), place<d>("uniform", random), changed));
    };
    const auto move_some = [&] {
        for (std::size_t k = 0; k < calls; ++k)
            REQUIRE(mesh.reinsert(home, static_cast<Index>(random() % mesh.vertex_bound()), place<d>("uniform", random),
                                  changed));
    };
    const auto crossed_by = [&](const auto& call) {
        changed.clear();
        const std::uint64_t before = mesh.landmarks().crossed();
        call();
        return static_cast<double>(mesh.landmarks().crossed() - before) / static_cast<double>(calls);
    };
    const double first = crossed_by(insert_some);  // and there were no landmarks
    const double inserted = crossed_by(insert_some);
    const double moved = crossed_by(move_some);
    CAPTURE(first, inserted, moved);
    CHECK(first < 64.0);
    CHECK(inserted > 1.0);
    CHECK(inserted < (d == 2 ? 16.0 : 24.0));
    CHECK(moved > 1.0);
    CHECK(moved < (d == 2 ? 16.0 : 24.0));
}

TEST_CASE("Landmarks that are gone, moved or not finite apart are hints like others", "[landmarks]") {
    Landmarks<2> landmarks;
    Points_d<2> x;
    for (int i = 0; i < 2000; ++i) x.push_back({i * 0x1p500, (i % 7) * 0x1p-500});
    const auto all = [](Index) { return true; };
    CHECK(landmarks.near(x, x.size(), {0, 0}, none, all) == none);
    CHECK(landmarks.near(x, x.size(), {0, 0}, 5, all) == 5);
    landmarks.note(1000, 2000);  // too long
    const Index near = landmarks.near(x, x.size(), x[600], none, all);
    CHECK(std::abs(near - 600) <= 64);
    CHECK(landmarks.near(x, x.size(), x[600], 601, all) == 601);
    CHECK(landmarks.near(x, x.size(), x[600], 4000, [](Index) { return false; }) == none);
    for (auto& p : x) p = {1.0 - p[0], p[1]};
    CHECK(landmarks.near(x, x.size(), x[600], none, all) >= 0);
    CHECK(landmarks.near(x, 10, x[600], none, all) < 10);  // there were more
}

TEMPLATE_TEST_CASE_SIG("Landmarks for which memory runs out can be used again, dimension", "[mesh]", ((int d), d), 2,
                       3) {
    Random random(6);
    std::vector<Coordinates<d>> x;
    for (int i = 0; i < 4000; ++i) x.push_back(place<d>("uniform", random));
    const auto present = [](Index) { return true; };
    for (std::uint64_t n = 0;; ++n) {
        Landmarks<d> landmarks;
        landmarks.note(5, 4000);  // so long a walk that they are renewed
        const Starved outcome =
            starve(n, Memory::short_once, [&] { (void)landmarks.near(x, x.size(), x[7], none, present); });
        CAPTURE(n, outcome);
        const Index v = landmarks.near(x, x.size(), x[7], none, present);
        CHECK((v >= 0 && v < 4000));
        if (outcome == Starved::done) break;
        REQUIRE(n < 10);
    }
}
