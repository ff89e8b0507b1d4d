// SPDX-License-Identifier: GPL-3.0-or-later
// The audit of periodic triangulations refuses tables that are wrong in one place.
#include <annulus/error.h>
#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/periodic_boxes.h>

#include <utility>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
Periodic_audit_input<d> case_of(std::size_t n, std::uint64_t seed) {
    Periodic_cases cases(seed);
    const Box<d> box = cases.box<d>(4);
    auto input = Periodic_mesh<d>(cases.points<d>(box, n), box).audit_input();
    input.most_faults = 100;
    return input;
}

template <int d>
void expect_only_right_ones_pass(std::size_t n, std::uint64_t seed) {
    const auto right = case_of<d>(n, seed);
    CHECK(audit(right).delaunay());
    const std::size_t cells = right.cells.vertices.size();
    for (std::size_t c = 0; c < cells; c += 1 + cells / 7) {
        CAPTURE(n, seed, c);
        auto wrong = right;
        ++wrong.cells.offsets[c][1][0];
        CHECK(!audit(wrong).delaunay());
        wrong = right;
        ++wrong.cells.translations[c][0][d - 1];
        CHECK(audit(wrong).topological_faults == 1);
        wrong = right;
        std::swap(wrong.cells.vertices[c][0], wrong.cells.vertices[c][1]);
        std::swap(wrong.cells.offsets[c][0], wrong.cells.offsets[c][1]);
        CHECK(audit(wrong).inverted_cells == 1);
        wrong = right;
        std::swap(wrong.cells.neighbours[c][0], wrong.cells.neighbours[c][1]);
        std::swap(wrong.cells.translations[c][0], wrong.cells.translations[c][1]);
        CHECK(!audit(wrong).delaunay());
        wrong = right;  // a cell less
        wrong.cells.vertices.erase(wrong.cells.vertices.begin() + static_cast<std::ptrdiff_t>(c));
        wrong.cells.offsets.erase(wrong.cells.offsets.begin() + static_cast<std::ptrdiff_t>(c));
        wrong.cells.neighbours.clear();
        wrong.cells.translations.clear();
        CHECK(!audit(wrong).delaunay());
        wrong = right;  // a cell twice
        wrong.cells.vertices.push_back(right.cells.vertices[c]);
        wrong.cells.offsets.push_back(right.cells.offsets[c]);
        wrong.cells.neighbours.clear();
        wrong.cells.translations.clear();
        CHECK(!audit(wrong).delaunay());
    }
    auto wrong = right;
    wrong.points.push_back(right.points[0]);
    const Audit_result missing = audit(wrong);
    CHECK(missing.topological_faults == 1);
    REQUIRE(missing.faults.size() == 1);
    CHECK(missing.faults[0].kind == Fault::unused_vertex);
    CHECK(missing.faults[0].vertices[0] == static_cast<Index>(n));
    wrong = right;
    wrong.cells.vertices[0][0] = static_cast<Index>(n);
    CHECK(audit(wrong).faults.at(0).kind == Fault::unknown_vertex);
}

}  // namespace

TEST_CASE("The periodic audit refuses a table with one changed offset, translation, neighbour, corner or cell",
          "[mesh][periodic]") {
    for (const std::size_t n : {1U, 2U, 3U, 12U, 40U}) {
        expect_only_right_ones_pass<2>(n, n);
        expect_only_right_ones_pass<3>(n, n);
    }
}

TEST_CASE("The periodic audit refuses positive, glued, locally Delaunay cells that cover the box twice",
          "[mesh][periodic]") {
    Periodic_audit_input<2> input;
    input.points = {{0, 0}};
    input.box = {{{1, 0}, {0.3125, 1}}};
    input.cells.vertices = {{0, 0, 0}, {0, 0, 0}};
    input.cells.offsets = {{{{0, 0}, {2, 0}, {0, 1}}}, {{{2, 0}, {2, 1}, {0, 1}}}};
    const Audit_result result = audit(input);
    CHECK(result.inverted_cells == 0);
    CHECK(result.violated_facets == 0);
    CHECK(result.topological_faults == 1);
    CHECK(result.first_fault == "the volumes of the cells do not add up to that of the box");
}

TEST_CASE("The periodic audit refuses an edge that is not Delaunay, and takes both diagonals of a square",
          "[mesh][periodic]") {
    Periodic_audit_input<2> input;
    input.points = {{0, 0}};
    input.box = {{{1, 0}, {0.25, 1}}};
    // The other diagonal of the parallelogram is the shorter one.
    input.cells.vertices = {{0, 0, 0}, {0, 0, 0}};
    input.cells.offsets = {{{{0, 0}, {1, 0}, {1, 1}}}, {{{0, 0}, {1, 1}, {0, 1}}}};
    CHECK(audit(input).violated_facets == 1);
    input.cells.offsets = {{{{0, 0}, {1, 0}, {0, 1}}}, {{{1, 0}, {1, 1}, {0, 1}}}};
    CHECK(audit(input).delaunay());
    input.box = {{{1, 0}, {0, 1}}};
    CHECK(audit(input).delaunay());
    CHECK(audit(input).degenerate_facets == 1);
    input.cells.offsets = {{{{0, 0}, {1, 0}, {1, 1}}}, {{{0, 0}, {1, 1}, {0, 1}}}};
    CHECK(audit(input).delaunay());
    input.cells.offsets.pop_back();
    CHECK_THROWS_AS(audit(input), Error);
}
