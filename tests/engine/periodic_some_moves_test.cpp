// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic_mesh::move of some vertices: all of them or none, whatever their order, onto places that others leave; where
// only cells near them change, and where it is a move of all.
#include <annulus/arithmetic/limits.h>
#include <annulus/error.h>
#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/cells_of_periodic.h>
#include <support/failing_new.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
using Points = std::vector<Coordinates<d>>;

/// Everything that can be seen, with the numbers of cells and what is cospherical.
template <int d>
auto everything(const Periodic_mesh<d>& mesh) {
    const auto of = [](auto span) { return std::vector(span.begin(), span.end()); };
    const auto cells = mesh.cells();
    Points<d> places = of(mesh.places());
    std::erase_if(places, [](const auto& p) { return std::isnan(p[0]); });  // which is not equal to itself
    return std::tuple(places, of(mesh.images()), mesh.saved().free_indices, cells.vertices, cells.offsets,
                      cells.neighbours, cells.translations, mesh.neighbours().area);
}

template <int d>
void expect_fresh(const Periodic_mesh<d>& mesh) {
    const Periodic_mesh<d> fresh(mesh.saved());
    CHECK(cells_of(mesh) == cells_of(fresh));
    CHECK(mesh.neighbour_counts() == fresh.neighbour_counts());  // by which facets are exactly empty
    CHECK(mesh.audit().first_fault.empty());
    CHECK(mesh.audit().delaunay());
}

/// The points of a cubic lattice, cospherical everywhere, or any.
template <int d>
Points<d> points_in_cube(Periodic_cases& cases, bool on_lattice, std::size_t side) {
    const std::size_t n = d == 2 ? side * side : side * side * side;
    Points<d> x = cases.points<d>(cases.box<d>(0), n);
    for (std::size_t k = 0; on_lattice && k < n; ++k)
        for (std::size_t i = 0, left = k; i < d; ++i, left /= side)
            x[k][i] = static_cast<double>(left % side) / static_cast<double>(side);
    return x;
}

/// Vertices that go to each other's places, around a cycle or in a chain that ends at a free place.
template <int d>
void expect_exchanges(bool on_lattice) {
    CAPTURE(d, on_lattice);
    Periodic_cases cases(5);
    const Points<d> x = points_in_cube<d>(cases, on_lattice, d == 2 ? 22 : 8);
    for (const std::size_t count : {2U, 3U, 7U})
        for (const bool chain : {false, true}) {
            Periodic_mesh<d> mesh(x, cases.box<d>(0), {.report_changes = true});
            std::vector<Index> which;
            Points<d> to;
            for (std::size_t k = 0; k < count; ++k) which.push_back(static_cast<Index>(37 * k + 11));
            for (std::size_t k = 0; k < count; ++k) to.push_back(x[static_cast<std::size_t>(which[(k + 1) % count])]);
            if (chain)
                for (double& c : to.back()) c += 3.0 / 64;
            to[0][0] += 2;  // another image
            Periodic_mesh<d> whole(x, cases.box<d>(0), {.report_changes = true}), turned(x, cases.box<d>(0));
            const Move_result result = mesh.move(which, to);
            CHECK((result.moves.asked == count && result.moves.reinserted == count));
            expect_fresh(mesh);
            for (std::size_t k = 0; k < count; ++k)
                for (std::size_t i = 0; i < d; ++i)
                    CHECK(mesh.points()[static_cast<std::size_t>(which[k])][i] == Approx(to[k][i]).epsilon(1e-12));

            Points<d> all = x;
            for (std::size_t k = 0; k < count; ++k) all[static_cast<std::size_t>(which[k])] = to[k];
            whole.move_all(all);
            const auto& a = mesh.changes();
            const auto& b = whole.changes();
            CHECK((a.made.first == b.made.first && a.made.second == b.made.second && a.made.shift == b.made.shift));
            CHECK((a.broken.first == b.broken.first && a.broken.shift == b.broken.shift));
            CHECK((a.changed.vertices == b.changed.vertices && a.changed.offsets == b.changed.offsets));
            CHECK((a.gone.vertices == b.gone.vertices && a.gone.offsets == b.gone.offsets));
            CHECK(!a.gone.vertices.empty());

            std::reverse(which.begin(), which.end());
            std::reverse(to.begin(), to.end());
            turned.move(which, to);
            CHECK(everything(turned) == everything(mesh));  // the order of the list is of no consequence
        }
}

template <class Call>
std::vector<std::int64_t> together(Call call) {
    try {
        call();
    } catch (const Error& e) {
        CHECK(e.code() == Error_code::duplicate_point);
        return {e.vertices().begin(), e.vertices().end()};
    }
    return {};
}

/// The last one of a list cannot be where it is to go: all others are where they were.
template <int d>
void expect_refusals(bool on_lattice) {
    CAPTURE(d, on_lattice);
    Periodic_cases cases(6);
    const Points<d> x = points_in_cube<d>(cases, on_lattice, d == 2 ? 16 : 7);
    Periodic_mesh<d> mesh(x, cases.box<d>(0));
    mesh.remove(8);
    const auto before = everything(mesh);
    const auto beside = [&](std::size_t v) {
        Coordinates<d> p = x[v];
        for (double& c : p) c += 0.3;
        p[0] += 5.0 / 128;
        return p;
    };
    using Named = std::vector<std::int64_t>;
    CHECK(together([&] { mesh.move(std::vector<Index>{3, 40}, Points<d>{beside(3), x[70]}); }) == Named{40, 70});
    CHECK(everything(mesh) == before);
    CHECK(together([&] {
              mesh.move(std::vector<Index>{3, 90, 40}, Points<d>{x[70], x[3], x[70]});
          }) == Named{3, 40, 70});
    CHECK(everything(mesh) == before);
    CHECK(together([&] {
              mesh.move(std::vector<Index>{3, 40, 4}, Points<d>{x[40], beside(9), beside(9)});
          }) == Named{4, 40});
    CHECK(everything(mesh) == before);
    CHECK(together([&] { mesh.move(std::vector<Index>{70, 40}, Points<d>{x[70], x[70]}); }) == Named{40, 70});
    CHECK(everything(mesh) == before);
    Coordinates<d> far{};
    far[0] = 1e300;
    CHECK_THROWS_AS(mesh.move(std::vector<Index>{3, 40}, Points<d>{beside(3), far}), Error);
    CHECK_THROWS_AS(mesh.move(std::vector<Index>{3, 8}, Points<d>{beside(3), x[8]}), Error);
    CHECK(everything(mesh) == before);
    expect_fresh(mesh);
    mesh.move(std::vector<Index>{70, 40, 3, 40}, Points<d>{beside(9), x[71], beside(3), x[70]});  // the last one of 40
    expect_fresh(mesh);
    for (std::size_t i = 0; i < d; ++i) CHECK(mesh.points()[40][i] == Approx(x[70][i]).epsilon(1e-12));
}

/// At every allocation, with places that others leave.
template <int d>
void expect_starved_moves(bool on_lattice, std::size_t count) {
    CAPTURE(d, on_lattice, count);
    Periodic_cases cases(7);
    const Points<d> x = points_in_cube<d>(cases, on_lattice, d == 2 ? 14 : 6);
    std::vector<Index> which;
    Points<d> to;
    for (std::size_t k = 0; k < count; ++k) which.push_back(static_cast<Index>(29 * k + 3));
    for (std::size_t k = 0; k < count; ++k) to.push_back(x[static_cast<std::size_t>(which[(k + 1) % count])]);
    for (double& c : to[0]) c += 0.3;
    int refused = 0;
    for (std::uint64_t n = 0;; ++n) {
        Periodic_mesh<d> mesh(x, cases.box<d>(0));
        mesh.remove(5);
        const auto before = everything(mesh);
        Move_result done;
        const auto outcome = starve(n, Memory::short_once, [&] { done = mesh.move(which, to); });
        if (outcome == Starved::done) {
            CHECK(done.moves.reinserted == count);
            expect_fresh(mesh);
            break;
        }
        if (outcome != Starved::refused) continue;
        ++refused;
        REQUIRE(everything(mesh) == before);
        REQUIRE(mesh.audit().delaunay());
        CHECK(mesh.move(which, to).moves.reinserted == count);  // nothing is left of it
        REQUIRE(cells_of(mesh) == cells_of(Periodic_mesh<d>(mesh.saved())));
    }
    CHECK(refused > 5);
}

/// Few that go far are reinserted, and many that go not so far are moved with all; tolerances are right after both.
template <int d>
void expect_cheaper_way() {
    CAPTURE(d);
    Periodic_cases cases(9);
    const Points<d> x = points_in_cube<d>(cases, false, d == 2 ? 20 : 8);
    Periodic_mesh<d> mesh(x, cases.box<d>(0), {.strategy = Periodic_strategy::tolerances});
    const auto move = [&](std::size_t count, double way) {
        std::vector<Index> which;
        Points<d> to;
        for (std::size_t k = 0; k < count; ++k) {
            which.push_back(static_cast<Index>(k));
            to.push_back(mesh.points()[k]);
            for (double& c : to.back()) c += way;
        }
        return mesh.move(which, to).moves;
    };
    const auto expect_tolerances = [&] {
        expect_fresh(mesh);
        const auto left = mesh.tolerances();
        const auto all = Periodic_mesh<d>(mesh.saved()).tolerances();
        for (std::size_t v = 0; v < all.size(); ++v) CHECK(left[v] <= all[v] * (1 + 1e-9));
    };
    Points<d> rest(mesh.points().begin(), mesh.points().end());
    for (auto& p : rest) p[0] += 1e-7;
    mesh.move_all(rest);  // begins tolerances
    CHECK(move(1, 1e-5).reinserted == 1);
    CHECK(move(4, 0.4).reinserted == 4);
    expect_tolerances();
    CHECK(move(200, 1e-6).asked == mesh.number_of_vertices());
    expect_tolerances();
    CHECK(move(200, 0.4).asked == mesh.number_of_vertices());
    expect_tolerances();
    CHECK(move(4, 1.0).kept_in_place == 4);  // other images
    CHECK(move(0, 1.0).asked == 0);
    expect_tolerances();
}

}  // namespace

TEST_CASE("Vertices of a periodic mesh go where others were, in any order", "[engine][periodic]") {
    for (const bool on_lattice : {false, true}) {
        expect_exchanges<2>(on_lattice);
        expect_exchanges<3>(on_lattice);
    }
}

TEST_CASE("Of some vertices of a periodic mesh all move or none", "[engine][periodic]") {
    for (const bool on_lattice : {false, true}) {
        expect_refusals<2>(on_lattice);
        expect_refusals<3>(on_lattice);
    }
}

TEST_CASE("A move of some vertices in a box that runs out of memory changes nothing", "[engine][periodic]") {
    for (const bool on_lattice : {false, true})
        for (const std::size_t count : {1U, 3U}) {
            if (Limits::tiny && on_lattice == (count == 1)) continue;  // with sanitizers they take half a minute
            expect_starved_moves<2>(on_lattice, count);
            expect_starved_moves<3>(on_lattice, count);
        }
}

TEST_CASE("Some vertices of a periodic mesh are moved in the cheaper of two ways", "[engine][periodic]") {
    expect_cheaper_way<2>();
    expect_cheaper_way<3>();
}
