// SPDX-License-Identifier: GPL-3.0-or-later
// The audit of any triangulation (annulus/audit.h): corners in any order, and faults in the caller's numbers. Whether
// cells are Delaunay is compared with rational numbers.
#include <annulus/audit.h>
#include <annulus/error.h>
#include <annulus/moving_mesh.h>

#include <support/catch.h>
#include <support/generators_3.h>
#include <support/meshes.h>
#include <support/repeats.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
using Cell = std::array<Index, static_cast<std::size_t>(d) + 1>;

template <int d>
Audit_result examine(const std::vector<Coordinates<d>>& x, const std::vector<Cell<d>>& cells, std::size_t most = 100) {
    return audit(std::span<const Coordinates<d>>(x), std::span<const Cell<d>>(cells), most);
}

int orientation(const std::vector<Coordinates<2>>& x, const Cell<2>& c) {
    const auto at = [&](std::size_t i) { return x[static_cast<std::size_t>(c[i])]; };
    return exact_orientation(at(0), at(1), at(2));
}
int orientation(const std::vector<Coordinates<3>>& x, const Cell<3>& c) {
    const auto at = [&](std::size_t i) { return x[static_cast<std::size_t>(c[i])]; };
    return exact_orientation(at(0), at(1), at(2), at(3));
}
/// Whether p is strictly inside the sphere of a positive cell.
bool inside(const std::vector<Coordinates<2>>& x, const Cell<2>& c, const Coordinates<2>& p) {
    const auto at = [&](std::size_t i) { return x[static_cast<std::size_t>(c[i])]; };
    return exact_empty_circle(at(0), at(1), at(2), p) < 0;
}
bool inside(const std::vector<Coordinates<3>>& x, const Cell<3>& c, const Coordinates<3>& p) {
    const auto at = [&](std::size_t i) { return x[static_cast<std::size_t>(c[i])]; };
    return exact_empty_sphere(at(0), at(1), at(2), at(3), p) < 0;
}

/// No vertex is strictly inside the sphere of any cell: by definition, O(n^2). For cells that are a triangulation.
template <int d>
bool is_delaunay(const std::vector<Coordinates<d>>& x, const std::vector<Cell<d>>& cells) {
    for (Cell<d> c : cells) {
        if (orientation(x, c) < 0) std::swap(c[0], c[1]);
        if (std::any_of(x.begin(), x.end(), [&](const auto& p) { return inside(x, c, p); })) return false;
    }
    return true;
}

template <int d>
std::vector<Cell<d>> shuffled(std::vector<Cell<d>> cells, Random& random) {
    for (auto& c : cells)
        for (std::size_t i = c.size(); i > 1; --i) std::swap(c[i - 1], c[random() % i]);
    for (std::size_t i = cells.size(); i > 1; --i) std::swap(cells[i - 1], cells[random() % i]);
    return cells;
}

bool lists(const Audit_result& r, Fault kind) {
    return std::any_of(r.faults.begin(), r.faults.end(), [kind](const Audit_fault& f) { return f.kind == kind; });
}

const std::vector<Coordinates<2>> kite{{0, 0}, {4, 0}, {5, 5}, {0, 4}};

}  // namespace

TEMPLATE_TEST_CASE_SIG("The orientation and order of corners do not matter, dimension", "[audit]", ((int d), d), 2, 3) {
    Random random(31);
    for (int run = 0; run < repeats(20); ++run) {
        std::vector<Coordinates<d>> x = grid<d>();
        if (run % 2 == 1)
            for (auto& p : x)
                for (double& c : p) c += between(random, -0.3, 0.3);
        const Moving_mesh<d> mesh{std::span<const Coordinates<d>>(x)};
        const auto cells = shuffled<d>(mesh.cells().vertices, random);
        const Audit_result r = examine<d>(x, cells);
        INFO(r.first_fault);
        CHECK(r.delaunay());
        CHECK(r.faults.empty());
        CHECK(r.degenerate_facets == mesh.audit().degenerate_facets);

        // Points that move a little leave a triangulation that is Delaunay or not.
        auto y = x;
        for (auto& p : y)
            for (double& c : p) c += between(random, -0.02, 0.02);
        const Audit_result moved = examine<d>(y, cells, 1000);
        if (moved.inverted_cells + moved.concave_ridges + moved.topological_faults == 0)
            CHECK(moved.delaunay() == is_delaunay<d>(y, cells));
        for (const Audit_fault& f : moved.faults) {
            if (f.kind != Fault::not_delaunay) continue;
            REQUIRE((f.cells[0] >= 0 && f.cells[1] >= 0));
            const auto& a = cells[static_cast<std::size_t>(f.cells[0])];
            const auto& b = cells[static_cast<std::size_t>(f.cells[1])];
            for (std::size_t k = 0; k < d; ++k) {  // the facet, then the other vertex of each
                CHECK(std::find(a.begin(), a.end(), f.vertices[k]) != a.end());
                CHECK(std::find(b.begin(), b.end(), f.vertices[k]) != b.end());
            }
            CHECK(std::find(a.begin(), a.end(), f.vertices[d]) != a.end());
            CHECK(std::find(b.begin(), b.end(), f.vertices[d + 1]) != b.end());
        }

        // Without one cell; with one twice; with a point in none; with two points at one position.
        auto fewer = cells;
        fewer.pop_back();
        CHECK_FALSE(examine<d>(x, fewer).delaunay());
        auto twice = cells;
        twice.push_back(cells[5]);
        std::swap(twice.back()[0], twice.back()[1]);
        const Audit_result double_cell = examine<d>(x, twice);
        CHECK(lists(double_cell, Fault::overlap));
        CHECK(double_cell.faults[0].cells[0] == 5);
        CHECK(double_cell.faults[0].cells[1] == static_cast<std::int64_t>(cells.size()));
        auto more = x;
        more.push_back(x[0]);
        const Audit_result unused = examine<d>(more, cells);
        CHECK(lists(unused, Fault::unused_vertex));
        CHECK(lists(unused, Fault::duplicate_point));
        CHECK(unused.topological_faults >= 2);
        for (const Audit_fault& f : unused.faults)
            if (f.kind == Fault::unused_vertex) CHECK(f.vertices[0] == static_cast<Index>(x.size()));
    }
}

TEST_CASE("An audit says which cells and vertices are at fault", "[audit]") {
    Audit_result r = examine<2>(kite, {{3, 1, 0}, {2, 1, 3}});
    CHECK(r.delaunay());
    r = examine<2>(kite, {{0, 1, 2}, {3, 0, 2}});
    REQUIRE(r.faults.size() == 1);
    CHECK(r.violated_facets == 1);
    CHECK(r.faults[0].kind == Fault::not_delaunay);
    CHECK(std::min(r.faults[0].cells[0], r.faults[0].cells[1]) == 0);
    CHECK(std::max(r.faults[0].cells[0], r.faults[0].cells[1]) == 1);
    CHECK_THAT(r.first_fault, contains("not locally Delaunay: edge, opposites 0 2"));
    CHECK_THAT(r.first_fault, contains("cells"));
    r = examine<2>(kite, {{0, 1, 3}, {1, 2, 4}});
    REQUIRE(r.faults.size() == 1);
    CHECK(r.faults[0].kind == Fault::unknown_vertex);
    CHECK(r.faults[0].cells[0] == 1);
    CHECK(examine<2>(kite, {{0, 1, -1}}).faults[0].cells[0] == 0);
    r = examine<2>({{0, 0}, {1, 0}, {2, 0}, {1, 2}}, {{0, 1, 3}, {1, 2, 3}, {2, 0, 1}});
    REQUIRE_FALSE(r.faults.empty());
    CHECK(r.faults[0].kind == Fault::flat_cell);
    CHECK(r.faults[0].cells[0] == 2);
    CHECK_THAT(r.first_fault, contains("flat cell:"));
    r = examine<2>({{0, 0}, {4, 0}, {1, 1}, {0, 4}}, {{0, 1, 2}, {0, 2, 3}});  // vertex 2 is a dent
    CHECK(lists(r, Fault::hull_not_convex));
    r = examine<2>(kite, {{0, 1, 3}, {1, 2, 3}, {0, 1, 2}});
    CHECK(lists(r, Fault::overlap));
    r = examine<2>(kite, {});
    CHECK_FALSE(r.delaunay());
    r = examine<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, {{0, 1, 2, 3}, {1, 2, 3, 4}, {0, 1, 2, 4}});
    CHECK(lists(r, Fault::overlap));
    for (const Audit_fault& f : r.faults)
        if (f.kind == Fault::overlap) CHECK((f.cells[0] >= 0 && f.cells[1] >= 0));
}

TEST_CASE("An audit of named vertices says which cells are at fault", "[audit]") {
    Audit_input<2> in{kite, {{0, 2, 1}, {3, 0, 2}}, {7, 3, 8, 40}};
    in.most_faults = 9;
    const Audit_result r = audit_unoriented(in);
    REQUIRE(r.faults.size() == 1);
    CHECK(r.faults[0].cells[0] + r.faults[0].cells[1] == 1);
    CHECK_THAT(r.first_fault, contains("edge, opposites 7 8"));
}

TEST_CASE("An audit counts all faults and lists some", "[audit]") {
    std::vector<Coordinates<2>> x = kite;
    for (int i = 0; i < 20; ++i) x.push_back({1 + 0.01 * i, 1});
    const std::vector<Cell<2>> cells{{0, 1, 3}, {1, 2, 3}};
    CHECK(examine<2>(x, cells).faults.size() == 20);
    for (const std::size_t most : {0U, 1U, 7U}) {
        const Audit_result r = examine<2>(x, cells, most);
        CHECK(r.faults.size() == most);
        CHECK(r.topological_faults == 20);
        CHECK_THAT(r.first_fault, contains("vertex in no cell: "));
    }
}

TEST_CASE("An audit takes flat points", "[audit]") {
    CHECK(examine<2>({{0, 0}, {2, 2}, {1, 1}}, {{0, 2, none}, {1, 2, none}}).delaunay());
    CHECK_FALSE(examine<2>({{0, 0}, {2, 2}, {1, 1}}, {{0, 1, none}, {1, 2, none}}).delaunay());
    CHECK(examine<2>({}, {}).delaunay());
    CHECK(examine<2>({{3, 4}}, {}).delaunay());
    const std::vector<Coordinates<3>> square{{0, 0, 1}, {1, 0, 1}, {2, 2, 1}, {0, 1, 1}};
    CHECK(examine<3>(square, {{0, 1, 3, none}, {1, 3, 2, none}}).delaunay());
    CHECK(examine<3>(square, {{1, 0, 3, none}, {1, 3, 2, none}}).delaunay());
    const Audit_result r = examine<3>(square, {{0, 1, 2, none}, {3, 0, 2, none}});
    REQUIRE(r.faults.size() == 1);
    CHECK(r.faults[0].kind == Fault::not_delaunay);
    CHECK((r.faults[0].cells[0] >= 0 && r.faults[0].cells[1] >= 0));
}

TEST_CASE("An audit refuses numbers that are not finite, and takes every other", "[audit]") {
    std::vector<Coordinates<2>> x = kite;
    x[2][1] = std::nan("");
    try {
        (void)examine<2>(x, {{0, 1, 3}, {1, 2, 3}});
        FAIL();
    } catch (const Error& e) {
        CHECK(e.code() == Error_code::not_finite);
        CHECK(e.vertices()[0] == 2);
    }
    x[2] = {0x1p900, 0x1p901};
    x[0] = {-0x1p-1074, 0};
    CHECK(examine<2>(x, {{0, 1, 3}, {1, 2, 3}}).delaunay());
}
