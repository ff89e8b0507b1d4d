// SPDX-License-Identifier: GPL-3.0-or-later
// Faults that only one condition of the audit finds: each of these inputs passes without this condition.
#include <annulus/audit.h>

#include <support/catch.h>

using annulus::audit;
using annulus::Audit_input;
using annulus::Audit_result;

TEST_CASE("The audit of space refuses a flat cell under the border", "[audit][space]") {
    // A pyramid on a square, and the square's two pairs of triangles as one cell without volume: nothing overlaps, all
    // spheres are empty.
    Audit_input<3> pyramid{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}, {{0, 1, 2, 4}, {0, 2, 3, 4}}};
    CHECK(audit(pyramid).delaunay());
    pyramid.cells.push_back({0, 2, 1, 3});
    const Audit_result r = audit(pyramid);
    INFO(r.first_fault);
    CHECK(r.inverted_cells == 1);
    CHECK(r.violated_facets + r.concave_ridges + r.topological_faults == 0);
}

TEST_CASE("The audit names a vertex that is in no cell", "[audit][space]") {
    const Audit_result r =
        audit(Audit_input<3>{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 2, 2}}, {{0, 1, 2, 3}}});
    CHECK(r.first_fault == "vertex in no cell: 4");
}

TEST_CASE("The audit refuses triangles that are not in one plane, though they are from above", "[audit][space]") {
    const Audit_input<3> flat{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 2, 0}}, {{0, 1, 2}, {0, 2, 3}}};
    for (const double height : {0.0, 0.5}) {
        Audit_input<3> input = flat;
        for (auto& c : input.cells) c[3] = annulus::none;
        input.points[3][2] = height;
        const Audit_result r = audit(input);
        INFO(r.first_fault);
        CHECK(r.delaunay() == (height == 0.0));
        CHECK(r.topological_faults == (height == 0.0 ? 0U : 1U));
    }
}

TEST_CASE("The audit refuses two vertices at one place of a line", "[audit]") {
    const Audit_result r =
        audit(Audit_input<2>{{{0, 0}, {0, 0}, {1, 0}}, {{0, 1, annulus::none}, {1, 2, annulus::none}}});
    INFO(r.first_fault);
    CHECK(r.topological_faults == 1);
}

TEST_CASE("The audit names vertices as the caller calls them, and without names by their index", "[audit]") {
    Audit_input<2> plane{{{0, 0}, {1, 0}, {0, 1}, {5, 5}}, {{0, 1, 2}}};
    CHECK(audit(plane).first_fault == "vertex in no cell: 3");
    CHECK(audit(plane, 1).first_fault == "vertex in no cell: 4");
    plane.names = {2, 3, 5, 70};
    CHECK(audit(plane).first_fault == "vertex in no cell: 70");
    plane.cells = {{0, 2, 1}};
    CHECK(audit(plane).first_fault == "cell not positively oriented: 2 5 3");
    plane.cells = {{0, 1, 4}};  // has no vertex, and so no name
    CHECK(audit(plane).first_fault == "a cell names a vertex that is not there: 2 3 4");
    Audit_input<3> space{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1, 3}}};
    space.names = {1, 4, 9, 16};
    CHECK(audit(space).first_fault == "cell not positively oriented: 1 9 4 16");
}

TEST_CASE("What an audit calls between two parts of its work can end it", "[audit]") {
    struct Enough {};
    Audit_input<2> strip;  // of unit squares, each cut in two
    const int squares = 2000;
    for (int i = 0; i <= squares; ++i) {
        strip.points.push_back({double(i), 0});
        strip.points.push_back({double(i), 1});
    }
    for (int i = 0; i < squares; ++i) {
        strip.cells.push_back({2 * i, 2 * i + 2, 2 * i + 1});
        strip.cells.push_back({2 * i + 2, 2 * i + 3, 2 * i + 1});
    }
    int calls = 0;
    strip.between = [&calls] { ++calls; };
    const Audit_result whole = audit(strip);
    CHECK(whole.delaunay());
    CHECK(calls >= 8);  // 4000 triangles and 8001 edges
    strip.between = [&calls] {
        if (++calls > 2) throw Enough{};
    };
    calls = 0;
    CHECK_THROWS_AS(audit(strip), Enough);
    CHECK(calls == 3);
}
