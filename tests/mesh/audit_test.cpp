// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/audit.h>

#include <support/catch.h>

#include <cmath>
#include <limits>

using annulus::audit;
using annulus::Audit_input;
using annulus::Audit_result;
using annulus::Index;
using annulus::none;

namespace {

using Cell = std::array<Index, 3>;

/// A square cut along the diagonal 0 2, far from cocircular, with a fifth vertex below the edge 0 1: valid as it is,
/// the base of the invalid inputs below.
Audit_input<2> kite() { return {{{0, 0}, {4, 0}, {5, 5}, {0, 4}, {2, -1}}, {{0, 1, 3}, {1, 2, 3}, {0, 4, 1}}}; }

void refuses(const Audit_input<2>& input) {
    const Audit_result r = audit(input);
    INFO(r.first_fault);
    CHECK_FALSE(r.delaunay());
    CHECK_FALSE(r.first_fault.empty());
}

void accepts(const Audit_input<2>& input) {
    const Audit_result r = audit(input);
    INFO(r.first_fault);
    CHECK(r.delaunay());
    CHECK(r.first_fault.empty());
}

}  // namespace

TEST_CASE("The audit passes Delaunay triangulations", "[audit]") {
    accepts(kite());
    CHECK(audit(kite()).degenerate_facets == 0);
    accepts({{{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}}});
    accepts({{{0, 0}, {1, 0}, {0, 1}}, {{2, 0, 1}}});
}

TEST_CASE("The audit passes either diagonal of a square and counts it as degenerate", "[audit]") {
    const std::vector<annulus::Coordinates<2>> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const auto& cells : {std::vector<Cell>{{0, 1, 2}, {0, 2, 3}}, std::vector<Cell>{{0, 1, 3}, {1, 2, 3}}}) {
        accepts({square, cells});
        CHECK(audit(Audit_input<2>{square, cells}).degenerate_facets == 1);
    }
}

TEST_CASE("The audit passes collinear vertices on the border", "[audit]") {
    accepts({{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, 2}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}}});
}

TEST_CASE("The audit counts vertices from the given number", "[audit]") {
    auto input = kite();
    std::swap(input.cells[1][0], input.cells[1][1]);
    CHECK(audit(input).first_fault == "cell not positively oriented: 2 1 3");
    CHECK(audit(input, 1).first_fault == "cell not positively oriented: 3 2 4");
}

TEST_CASE("The audit refuses an inverted cell", "[audit]") {
    auto input = kite();
    std::swap(input.cells[1][0], input.cells[1][1]);
    refuses(input);
    CHECK(audit(input).inverted_cells == 1);
    refuses({{{0, 0}, {1, 0}, {0, 1}}, {{0, 2, 1}}});
}

TEST_CASE("The audit refuses a flat cell and one that names a vertex twice", "[audit]") {
    refuses({{{0, 0}, {1, 0}, {2, 0}, {1, 2}}, {{0, 1, 2}, {0, 2, 3}}});
    CHECK(audit(Audit_input<2>{{{0, 0}, {1, 0}, {2, 0}, {1, 2}}, {{0, 1, 2}, {0, 2, 3}}}).inverted_cells == 1);
    refuses({{{0, 0}, {1, 0}, {0, 1}}, {{0, 0, 1}}});
    refuses({{{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}, {1, 1, 1}}});
}

TEST_CASE("The audit refuses a vertex that is in no cell", "[audit]") {
    auto input = kite();
    input.points.push_back({2, 2.5});
    refuses(input);
    input.points.back() = {100, 100};
    refuses(input);
}

TEST_CASE("The audit refuses an edge whose circle holds the opposite vertex", "[audit]") {
    auto input = kite();
    input.cells = {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}};
    CHECK(audit(input).violated_facets == 1);
    refuses(input);
    // By one unit in the last place.
    const double up = std::nextafter(1.0, 2.0);
    const double down = std::nextafter(1.0, 0.0);
    refuses({{{0, 0}, {1, 0}, {up, up}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}}});
    accepts({{{0, 0}, {1, 0}, {up, up}, {0, 1}}, {{0, 1, 3}, {1, 2, 3}}});
    refuses({{{0, 0}, {1, 0}, {down, down}, {0, 1}}, {{0, 1, 3}, {1, 2, 3}}});
    accepts({{{0, 0}, {1, 0}, {down, down}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}}});
}

TEST_CASE("The audit decides where doubles overflow or underflow", "[audit]") {
    for (const double scale : {0x1p-1070, 0x1p-600, 0x1p-400, 1.0, 0x1p400, 0x1p497}) {
        auto good = kite();
        for (auto& p : good.points)
            for (double& c : p) c *= scale;
        accepts(good);
        auto bad = good;
        bad.cells = {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}};
        refuses(bad);
    }
    // Both ends of the domain in one set.
    accepts({{{0, 0}, {0x1p500, 0}, {0, 0x1p500}, {0x1p-1074, 0x1p-1074}}, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
    refuses({{{0, 0}, {0x1p500, 0}, {0, 0x1p500}, {0x1p-1074, -0x1p-1074}}, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
}

TEST_CASE("The audit refuses a border that is not convex", "[audit]") {
    auto input = kite();
    input.cells.pop_back();
    input.points.pop_back();
    input.points[2] = {1.5, 1.5};  // the vertex 2 behind the edge 1 3
    refuses(input);
    // A hull triangle left out.
    refuses({{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1}}, {{1, 2, 4}, {2, 3, 4}, {3, 0, 4}}});
    CHECK(audit(Audit_input<2>{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1}}, {{1, 2, 4}, {2, 3, 4}, {3, 0, 4}}})
              .concave_ridges == 1);
}

TEST_CASE("The audit refuses two vertices at one place", "[audit]") {
    refuses({{{0, 0}, {1, 0}, {0, 1}, {1, 0}}, {{0, 1, 2}}});
    refuses({{{0, 0}, {1, 0}, {0, 1}, {1, 0}}, {{0, 1, 2}, {1, 3, 2}}});
    refuses({{{0, 0}, {1, 0}, {-0.0, 0.0}}, {{0, 1, none}}});
}

TEST_CASE("The audit refuses a doubled cell", "[audit]") {
    auto input = kite();
    input.cells.push_back(input.cells[1]);
    refuses(input);
    input = kite();
    input.cells.push_back({2, 3, 1});  // the same, turned
    refuses(input);
}

TEST_CASE("The audit refuses an edge with three cells", "[audit]") {
    auto input = kite();
    input.points.push_back({4, 3});
    input.cells.push_back({1, 5, 3});
    refuses(input);
}

TEST_CASE("The audit refuses a border that winds twice, where every cell and edge holds", "[audit]") {
    const std::vector<annulus::Coordinates<2>> star{{100, 0}, {31, 95}, {-81, 59}, {-81, -59}, {31, -95}, {0, 0}};
    accepts({star, {{0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {4, 0, 5}}});
    const Audit_input<2> twice{star, {{0, 2, 5}, {2, 4, 5}, {4, 1, 5}, {1, 3, 5}, {3, 0, 5}}};
    const Audit_result r = audit(twice);
    CHECK(r.inverted_cells + r.violated_facets + r.concave_ridges == 0);
    refuses(twice);
    // Without a vertex inside: the angle at 3 is beyond 2 pi.
    refuses({{{868, 1543}, {1240, 635}, {1055, 884}, {1127, 808}, {654, 1545}}, {{0, 2, 3}, {1, 3, 2}, {1, 4, 3}}});
}

TEST_CASE("The audit refuses two components", "[audit]") {
    refuses({{{0, 0}, {1, 0}, {0, 1}, {10, 10}, {11, 10}, {10, 11}}, {{0, 1, 2}, {3, 4, 5}}});
    // Sharing a vertex.
    refuses({{{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}}, {{0, 1, 2}, {0, 3, 4}}});
    // One inside the other.
    refuses({{{-9, -9}, {9, -9}, {0, 9}, {-1, -1}, {1, -1}, {0, 1}}, {{0, 1, 2}, {3, 4, 5}}});
}

TEST_CASE("The audit refuses a hole", "[audit]") {
    const std::vector<annulus::Coordinates<2>> points{{-9, -9}, {9, -9}, {0, 12}, {-1, -1}, {1, -1}, {0, 1}};
    refuses({points, {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 0, 5}, {0, 3, 5}}});
}

TEST_CASE("The audit refuses indices that name no vertex", "[audit]") {
    for (const Index bad : {-1, -7, 3, 1000000, std::numeric_limits<Index>::max(), std::numeric_limits<Index>::min()}) {
        refuses({{{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}, {bad, 1, 0}}});
        refuses({{{0, 0}, {1, 0}, {0, 1}}, {{0, bad, 2}}});
        refuses({{{0, 0}, {1, 0}, {2, 0}}, {{0, 1, none}, {bad, 2, none}}});
    }
}

TEST_CASE("The audit refuses a surface without a border", "[audit]") {
    refuses({{{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}, {1, 0, 2}}});
}

TEST_CASE("The audit passes no point, one, and points on a line joined in their order", "[audit]") {
    accepts({});
    accepts({{{3, 4}}, {}});
    accepts({{{0, 0}, {2, 2}}, {{0, 1, none}}});
    accepts({{{0, 0}, {2, 2}, {1, 1}}, {{0, 2, none}, {1, 2, none}}});
    accepts({{{5, 3}, {5, -1}, {5, 0}}, {{2, 0, none}, {1, 2, none}}});
}

TEST_CASE("The audit refuses wrong edges on a line", "[audit]") {
    refuses({{{0, 0}, {2, 2}}, {}});
    refuses({{{0, 0}, {2, 2}, {1, 1}}, {{0, 1, none}, {1, 2, none}}});
    refuses({{{0, 0}, {2, 2}, {1, 1}}, {{0, 2, none}}});
    refuses({{{0, 0}, {2, 2}, {1, 1}}, {{0, 2, none}, {1, 2, none}, {1, 2, none}}});
    refuses({{{0, 0}, {2, 2}, {1, 1}}, {{0, 2, none}, {1, none, none}}});
}

TEST_CASE("The audit refuses edges alone when the points are not on a line", "[audit]") {
    refuses({{{0, 0}, {1, 1}, {2, std::nextafter(2.0, 3.0)}}, {{0, 1, none}, {1, 2, none}}});
    refuses({{{0, 0}, {1, 0}, {0, 1}}, {}});
}

TEST_CASE("The audit refuses a triangle among edges and an edge among triangles", "[audit]") {
    refuses({{{0, 0}, {1, 1}, {2, 2}}, {{0, 1, 2}}});
    refuses({{{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}, {0, 1, none}}});
}

TEST_CASE("The audit refuses cells that name vertices where there are none", "[audit]") {
    refuses({{}, {{0, 1, none}}});
    refuses({{{3, 4}}, {{0, 0, none}}});
    refuses({{{3, 4}}, {{7, none, none}}});
    refuses({{}, {{0, 1, 2}}});
}
