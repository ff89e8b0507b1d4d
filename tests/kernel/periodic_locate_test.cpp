// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic_mesh::find_cell: the cell that is named contains the point, by integers; the search where walks go too far.
#include <annulus/error.h>
#include <annulus/kernel/periodic_builder.h>
#include <annulus/kernel/periodic_locate.h>
#include <annulus/periodic_mesh.h>
#include <annulus/predicate/exact_sign.h>

#include <support/catch.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

/// Whether a cell, at the images that a location says, contains p: everything is a multiple of 2^-20, so exact.
template <int d>
bool contains(const Periodic_mesh<d>& mesh, const Periodic_cells<d>& cells, const Periodic_location<d>& at,
              const Coordinates<d>& p) {
    std::array<Coordinates<d>, static_cast<std::size_t>(d + 1)> x;
    const auto c = static_cast<std::size_t>(at.cell);
    for (std::size_t k = 0; k <= d; ++k) {
        x[k] = mesh.points()[static_cast<std::size_t>(cells.vertices[c][k])];
        for (std::size_t j = 0; j < d; ++j)
            for (std::size_t i = 0; i < d; ++i)
                x[k][i] += (cells.offsets[c][k][j] + at.shift[j]) * mesh.box().vectors()[j][i];
    }
    for (std::size_t i = 0; i <= d; ++i) {
        Tuple<d, d + 1> corners;
        for (std::size_t j = 0; j <= d; ++j) corners[j] = j == i ? &p : &x[j];
        if (exact_orientation_sign(corners).sign < 0) return false;
    }
    return true;
}

template <int d>
void expect_found(int kind, std::size_t n, std::uint64_t seed) {
    CAPTURE(d, kind, n, seed);
    Periodic_cases cases(seed);
    auto vectors = cases.box<d>(kind).vectors();
    for (auto& v : vectors) v = coarse(v);
    const Box<d> box(vectors);
    auto x = cases.points<d>(box, n, 2);
    for (auto& p : x) p = coarse(p);
    const Periodic_mesh<d> mesh(x, box);
    const auto cells = mesh.cells();
    auto queries = cases.points<d>(box, 30, 3);
    for (auto& p : queries) p = coarse(p);
    queries.push_back(x[0]);  // a vertex, and the middle of two
    queries.push_back(x[n - 1]);
    for (std::size_t i = 0; i < d; ++i) queries.back()[i] = (x[0][i] + x[n - 1][i] + vectors[0][i]) / 2;
    const auto found = mesh.find_cells(queries);
    REQUIRE(found.size() == queries.size());
    for (std::size_t k = 0; k < queries.size(); ++k) {
        REQUIRE((found[k].cell >= 0 && static_cast<std::size_t>(found[k].cell) < mesh.number_of_cells()));
        CHECK(contains(mesh, cells, found[k], queries[k]));
        const auto alone = mesh.find_cell(queries[k]);
        CHECK((alone.cell == found[k].cell && alone.shift == found[k].shift));
    }
}

/// The search without a walk finds the same, where the point is not on a facet.
template <int d>
void expect_search_agrees(int kind) {
    CAPTURE(d, kind);
    Periodic_cases cases(6);
    const Box<d> box = cases.box<d>(kind);
    const Lattice<d> lattice(box.vectors());
    std::vector<Coordinates<d>> place;
    for (const auto& p : cases.points<d>(box, 25)) place.push_back(lattice.representative(p, 0).place);
    Periodic_table<d> table;
    Periodic_builder<d>().build(lattice, place, 1, table);
    for (int k = 0; k < 10; ++k) {
        const Coordinates<d> p = lattice.representative(cases.point<d>(box, 2), 0).place;
        const Lifted_cell<d> at = search_for<d>(table, lattice, place, p);
        if (const auto walked = walk_to<d>(table, lattice, place, p)) CHECK(*walked == at);
        CHECK(locate<d>(table, lattice, place, p) == at);
    }
}

}  // namespace

TEST_CASE("The cell of a periodic mesh that is found contains the point", "[kernel][periodic]") {
    for (int kind = 0; kind < Periodic_cases::kinds; ++kind)
        for (int k = 0; k < repeats(1); ++k)
            for (const std::size_t n : {1U, 2U, 9U, 200U}) {
                expect_found<2>(kind, n, static_cast<std::uint64_t>(k));
                expect_found<3>(kind, n, static_cast<std::uint64_t>(k));
            }
}

TEST_CASE("A search through all cells of a box finds what a walk finds", "[kernel][periodic]") {
    for (int kind = 0; kind < Periodic_cases::kinds; ++kind) {
        expect_search_agrees<2>(kind);
        expect_search_agrees<3>(kind);
    }
}

TEST_CASE("Points that no cell of a box contains, and those that are refused", "[kernel][periodic]") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    const Box<2> box = Box<2>::orthorhombic({1, 1});
    const Periodic_mesh<2> none({}, box);
    CHECK(none.find_cell({0.5, 0.5}).cell == -1);
    const Periodic_mesh<2> mesh(std::vector<Coordinates<2>>{{0.25, 0.5}}, box);
    CHECK(mesh.find_cells({}).empty());
    CHECK(mesh.find_cell({0.5, nan}).cell == -1);
    for (const auto& [x, code] : {std::pair(infinity, Error_code::not_finite), {1e40, Error_code::out_of_domain}}) {
        try {
            (void)mesh.find_cells(std::vector<Coordinates<2>>{{0.5, 0.5}, {x, 0}});
            FAIL("no error");
        } catch (const Error& e) {
            CHECK(e.code() == code);
            CHECK((e.vertices().size() == 1 && e.vertices()[0] == 1));
        }
    }
}
