// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/audit.h>
#include <annulus/internal/types_3.h>

#include <common/oracle_3.h>

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/point_sets_3.h>

#include <cmath>
#include <limits>

using namespace annulus;
using namespace annulus::testing;

namespace {

using Cell = std::array<Index, 4>;
using Input = Audit_input<3>;

void refuses(const Input& input) {
    const Audit_result r = audit(input);
    INFO(r.first_fault);
    CHECK_FALSE(r.delaunay());
    CHECK_FALSE(r.first_fault.empty());
}

void accepts(const Input& input) {
    const Audit_result r = audit(input);
    INFO(r.first_fault);
    CHECK(r.delaunay());
    CHECK(r.first_fault.empty());
}

/// Two cells on the facet 0 1 2, one vertex far above and one far below, so that their edge would cross it.
Input tent() {
    return {{{1, 0, 0}, {-0.5, 0.75, 0}, {-0.5, -0.75, 0}, {0, 0, 2}, {0, 0, -2}}, {{0, 1, 2, 3}, {1, 0, 2, 4}}};
}

/// The five points of docs/theory.md 3, as their three cells around the edge 0 1.
Input spindle(double delta) {
    const double s = std::sqrt(0.75);
    return {{{0, 0, 1 - delta}, {0, 0, delta - 1}, {1, 0, 0}, {-0.5, s, 0}, {-0.5, -s, 0}},
            {{2, 3, 1, 0}, {3, 4, 1, 0}, {4, 2, 1, 0}}};
}

/// Its two cells on the other three.
Input spindle_flipped(double delta) {
    Input input = spindle(delta);
    input.cells = {{2, 3, 4, 0}, {3, 2, 4, 1}};
    return input;
}

Input triangulated(const Points_3& points) {
    Delaunay_3<No_info> tr;
    for (std::size_t i = 0; i < points.size(); ++i)
        tr.insert(Delaunay_3<No_info>::Point(points[i][0], points[i][1], points[i][2]))
            ->set_index(static_cast<Index>(i));
    Input input{points, {}};
    if (tr.dimension() == 3)
        for (auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
            input.cells.push_back(
                {c->vertex(0)->index(), c->vertex(1)->index(), c->vertex(2)->index(), c->vertex(3)->index()});
    else input.cells = oracle::cells_of(tr);
    return input;
}

}  // namespace

TEST_CASE("The audit of space passes Delaunay triangulations", "[audit][space]") {
    accepts({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}});
    accepts(tent());
    accepts(spindle(0.01));
    accepts(spindle_flipped(-0.01));
}

TEST_CASE("The audit of space passes what CGAL builds, of every family", "[audit][space]") {
    for (const Set_3 set : all_sets_3) {
        if (set == Set_3::plane || set == Set_3::line || set == Set_3::scaled)
            continue;  // flat ones have a separate test
        CAPTURE(name_of(set));
        Random random(11);
        for (const int n : {4, 5, 8, 30, 100}) {
            const Input input = triangulated(point_set(set, static_cast<std::size_t>(n), random));
            accepts(input);
            if (input.cells.size() < 2 || input.cells.front()[3] == none) continue;
            // Any cell inverted, doubled or left out.
            for (std::size_t k = 0; k < input.cells.size(); k += 1 + input.cells.size() / 5) {
                Input bad = input;
                std::swap(bad.cells[k][0], bad.cells[k][1]);
                refuses(bad);
                bad = input;
                bad.cells.push_back(bad.cells[k]);
                refuses(bad);
                bad = input;
                bad.cells.erase(bad.cells.begin() + static_cast<std::ptrdiff_t>(k));
                refuses(bad);
            }
        }
    }
}

TEST_CASE("The audit of space refuses a facet whose sphere holds the opposite vertex", "[audit][space]") {
    CHECK(audit(spindle(-0.01)).violated_facets == 3);
    CHECK(audit(spindle_flipped(0.01)).violated_facets == 1);
    refuses(spindle(-0.01));
    refuses(spindle_flipped(0.01));
    // A cube corner pushed by one unit in the last place.
    const double up = std::nextafter(1.0, 2.0);
    Input octahedron{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                     {{0, 2, 4, 5}, {2, 1, 4, 5}, {1, 3, 4, 5}, {3, 0, 4, 5}}};
    for (Cell& c : octahedron.cells) std::swap(c[2], c[3]);
    accepts(octahedron);
    CHECK(audit(octahedron).degenerate_facets == 4);
    octahedron.points[0][0] = up;
    accepts(octahedron);
    octahedron.points[4][2] = up;
    octahedron.points[0][0] = 1;
    refuses(octahedron);
}

TEST_CASE("The audit of space refuses flat cells and cells that name a vertex twice", "[audit][space]") {
    refuses({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2, 3}}});
    refuses({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 0, 1, 2}}});
}

TEST_CASE("The audit of space refuses a vertex in no cell and two at one place", "[audit][space]") {
    Input input = tent();
    input.points.push_back({0, 0, 0.5});
    refuses(input);
    input.points.back() = {9, 9, 9};
    refuses(input);
    input.points.back() = input.points[0];
    refuses(input);
}

TEST_CASE("The audit of space refuses a boundary that is not convex", "[audit][space]") {
    Input input = spindle(0.01);
    input.cells.pop_back();
    refuses(input);
    // The vertex below is visible beyond the edge of the base.
    input = tent();
    input.points[4] = {3, 0, -0.5};
    refuses(input);
    CHECK(audit(input).concave_ridges > 0);
}

TEST_CASE("The audit of space refuses two components, one in another, a shared vertex or edge", "[audit][space]") {
    const Points_3 one{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Input two{one, {{0, 1, 2, 3}, {4, 5, 6, 7}}};
    for (auto p : one) two.points.push_back({p[0] + 9, p[1], p[2]});
    refuses(two);
    Input inside{{{-9, -9, -9}, {20, -9, -9}, {-9, 20, -9}, {-9, -9, 20}}, {{0, 1, 2, 3}, {4, 5, 6, 7}}};
    for (auto p : one) inside.points.push_back(p);
    refuses(inside);
    refuses({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
             {{0, 1, 2, 3}, {0, 5, 4, 6}}});
    refuses({{{0, 0, -1}, {0, 0, 1}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}, {-1, -1, 0}}, {{0, 3, 2, 1}, {0, 4, 5, 1}}});
}

TEST_CASE("The audit of space refuses a bipyramid that winds twice, where every certificate holds", "[audit][space]") {
    // A pentagon around the edge 0 1, its corners permuted to a pentagram: cells positive, spheres empty, ridges
    // convex.
    Input input{{{0, 0, 0.3}, {0, 0, -0.3}}, {}};
    for (const int k : {0, 1, 2, 3, 4}) {
        const double turn = 1.2566370614359172 * k;
        input.points.push_back({std::cos(turn), std::sin(turn), 0});
    }
    for (const Index step : {1, 2}) {
        input.cells.clear();
        for (Index k = 0; k < 5; ++k) input.cells.push_back({2 + step * k % 5, 2 + step * (k + 1) % 5, 1, 0});
        const Audit_result r = audit(input);
        INFO(r.first_fault);
        CHECK(r.inverted_cells + r.violated_facets + r.concave_ridges == 0);
        CHECK(r.delaunay() == (step == 1));
    }
}

TEST_CASE("The audit of space judges points of a plane and of a line in theirs", "[audit][space]") {
    accepts({});
    accepts({{{3, 4, 5}}, {}});
    accepts({{{0, 0, 0}, {2, 2, 2}}, {{0, 1, none, none}}});
    accepts({{{0, 0, 0}, {2, 2, 4}, {1, 1, 2}}, {{0, 2, none, none}, {1, 2, none, none}}});
    refuses({{{0, 0, 0}, {2, 2, 4}, {1, 1, 2}}, {{0, 1, none, none}, {1, 2, none, none}}});
    refuses({{{0, 0, 0}, {2, 2, 4}, {1, 1, 3}}, {{0, 2, none, none}, {1, 2, none, none}}});
    refuses({{{0, 0, 0}, {2, 2, 4}}, {}});
    accepts({{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}}, {{0, 1, 2, none}}});
    accepts({{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}}, {{0, 2, 1, none}}});
    refuses({{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}, {{0, 1, 2, none}}});
    // A kite in the plane x = y + z: a circle there is none seen from above.
    const Points_3 kite{{0, 0, 0}, {4, 0, 4}, {10, 5, 5}, {4, 4, 0}};
    const Audit_result one = audit({kite, {{0, 1, 3, none}, {1, 2, 3, none}}});
    const Audit_result other = audit({kite, {{0, 1, 2, none}, {0, 2, 3, none}}});
    CHECK(one.delaunay() != other.delaunay());
    for (const Set_3 set : {Set_3::plane, Set_3::line}) {
        Random random(5);
        for (const int n : {0, 1, 2, 3, 4, 10, 40}) {
            Points_3 points = point_set(set, static_cast<std::size_t>(n), random);
            for (auto& p : points) p = {p[0], p[1], p[0] - 2 * p[1]};  // tilted
            Delaunay_3<No_info> tr;
            for (std::size_t i = 0; i < points.size(); ++i)
                tr.insert(Delaunay_3<No_info>::Point(points[i][0], points[i][1], points[i][2]))
                    ->set_index(static_cast<Index>(i));
            Input input{points, {}};
            if (tr.dimension() == 2)
                for (auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
                    input.cells.push_back({f->first->vertex(0)->index(), f->first->vertex(1)->index(),
                                           f->first->vertex(2)->index(), none});
            if (tr.dimension() == 1)
                for (auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e)
                    input.cells.push_back(
                        {e->first->vertex(e->second)->index(), e->first->vertex(e->third)->index(), none, none});
            accepts(input);
            if (!input.cells.empty()) {
                input.cells.pop_back();
                refuses(input);
            }
        }
    }
}

TEST_CASE("The audit of space refuses indices that name no vertex", "[audit][space]") {
    for (const Index bad : {-1, -7, 4, 1000000, std::numeric_limits<Index>::max(), std::numeric_limits<Index>::min()})
        refuses({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}, {bad, 1, 2, 0}}});
    refuses({{}, {{0, 1, 2, 3}}});
}
