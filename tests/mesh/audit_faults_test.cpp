// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of which the audit has one witness only: each of these inputs passes when the one condition that it breaks is not
// looked at.
#include <annulus/mesh/audit.h>

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
