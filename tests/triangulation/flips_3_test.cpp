// SPDX-License-Identifier: GPL-3.0-or-later
// Flips of space in the mirror and in CGAL's object: made, and made back.
#include <annulus/triangulation/cgal_embedding_3.h>
#include <annulus/triangulation/flips_3.h>

#include <support/session_3.h>

#include <catch2/catch.hpp>

using namespace annulus;
using namespace annulus::testing;

namespace {

using Embedding_3 = Cgal_embedding_3<No_info>;

/// Every cell of the mirror, sorted within and among themselves: a triangulation whatever its numbers.
Cells_3 cells_of_mirror(const Cell_table<3>& t) {
    Cells_3 cells;
    for (Index c = 0; c < t.cell_bound(); ++c) {
        if (!t.is_cell(c)) continue;
        auto x = cell_points(t, c);
        std::sort(x.begin(), x.end());
        cells.push_back(x);
    }
    std::sort(cells.begin(), cells.end());
    return cells;
}

void check_same(const Embedding_3& e) {
    const auto& tr = e.triangulation();
    CHECK(tr.tds().is_valid());
    for (auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
        for (int i = 0; i <= 3; ++i) {
            const Index h = e.table().corner(c->cell(), i);
            REQUIRE(e.table().vertex(h) == (tr.is_infinite(c->vertex(i)) ? infinite : c->vertex(i)->index()));
            REQUIRE(e.table().twin(h) == e.table().corner(c->neighbor(i)->cell(), tr.tds().mirror_index(c, i)));
            REQUIRE(e.table().facet(h) == e.table().facet(e.table().twin(h)));
            REQUIRE(e.table().is_facet(e.table().facet(h)));
        }
}

/// Makes the flip and takes it back by its own cells.
void there_and_back(Embedding_3& e, const Flip_3& flip) {
    const Cells_3 before = cells_of_mirror(e.table());
    std::vector<Cell_points<3>> gone;
    for (const Index c : flip.gone()) gone.push_back(cell_points(e.table(), c));
    std::vector<Index> created;
    e.replace(flip.gone(), flip.came(), created);
    CHECK(created.size() == flip.came().size());
    CHECK(cells_of_mirror(e.table()) != before);
    check_same(e);
    std::vector<Index> restored;
    e.replace(created, gone, restored);
    CHECK(cells_of_mirror(e.table()) == before);
    check_same(e);
}

}  // namespace

TEST_CASE("The spindle flips from three cells to two, the long one from two to three", "[flips][space]") {
    for (const double pole : {0.5, 2.0}) {
        Embedding_3 e;
        e.build(Points_3{{0, 0, pole}, {0, 0, -pole}, {1, 0, 0}, {-0.5, 0.75, 0}, {-0.5, -0.75, 0}});
        e.mirror();
        const auto& t = e.table();
        REQUIRE(e.triangulation().number_of_finite_cells() == (pole < 1 ? 3 : 2));
        int three_two = 0;  // among the offers, by the edge of the poles
        int two_three = 0;
        for (Index c = 0; c < t.cell_bound(); ++c)
            for (int i = 0; i <= 3; ++i) {
                if (flip_2_3(t, t.corner(c, i))) ++two_three;
                for (int j = 0; j < i; ++j)
                    if (flip_3_2(t, c, i, j)) ++three_two;
            }
        // The first is the join of two triangles, 0 1 infinity and 2 3 4: every edge of one has the other around it, and three
        // cells. In the second 0 and 1 are the only vertices not adjacent, with four facets between them: 2 3 4 and three at infinity.
        CHECK(two_three == (pole < 1 ? 0 : 4 * 2));
        CHECK(three_two == (pole < 1 ? 6 * 3 : 0));
        if (pole > 1) continue;
        for (Index k = 0; k < t.cell_bound(); ++k) {
            const int i = t.slot(k, 0);
            const int j = t.slot(k, 1);
            if (i < 0 || j < 0 || !t.is_cell(k)) continue;
            const auto flip = flip_3_2(t, k, i, j);
            REQUIRE(flip);
            CHECK(flip->gone().size() == 3);
            CHECK(flip->came().size() == 2);
            there_and_back(e, *flip);
            break;
        }
    }
}

TEST_CASE("Every flip that is offered is simplicial, keeps mirror and CGAL the same and can be taken back",
          "[flips][space]") {
    std::array<int, 3> made{};
    for (const Set_3 set : {Set_3::uniform, Set_3::lattice, Set_3::sphere}) {
        Random random(17);
        Embedding_3 e;
        e.build(point_set(set, 30, random));
        REQUIRE(e.dimension() == 3);
        e.mirror();
        const auto& t = e.table();
        for (int attempt = 0; attempt < 600; ++attempt) {
            const auto c = static_cast<Index>(random() % static_cast<std::size_t>(t.cell_bound()));
            if (!t.is_cell(c)) continue;
            const int i = static_cast<int>(random() % 4);
            const int j = (i + 1 + static_cast<int>(random() % 3)) % 4;
            const std::size_t kind = random() % 3;
            const auto flip = kind == 0   ? flip_2_3(t, t.corner(c, i))
                              : kind == 1 ? flip_3_2(t, c, i, j)
                                          : flip_4_4(t, t.corner(c, i), t.corner(c, j));
            if (!flip) continue;
            ++made[kind];
            if (random() % 2 == 0) {
                there_and_back(e, *flip);
            } else {  // go on from there: the triangulation drifts away from any embedding
                std::vector<Index> created;
                e.replace(flip->gone(), flip->came(), created);
                check_same(e);
            }
            const Cells_3 cells = cells_of_mirror(t);
            REQUIRE(std::adjacent_find(cells.begin(), cells.end()) == cells.end());
        }
    }
    for (const int n : made) CHECK(n > 10);
}

TEST_CASE("The corners of a ridge and of a bi-cell are in the order that the certificates take", "[flips][space]") {
    Random random(29);
    Embedding_3 e;
    const Points_3 x = point_set(Set_3::uniform, 60, random);
    e.build(x);
    e.mirror();
    const auto& t = e.table();
    const auto at = [&](Index v) { return &x[static_cast<std::size_t>(v)]; };
    int ridges = 0;
    for (Index f = 0; f < t.facet_bound(); ++f) {
        REQUIRE(t.is_facet(f));
        for (const Index h : {t.half(f), t.twin(t.half(f))}) {
            const Facet_kind kind = facet_kind(t, h);
            if (kind == Facet_kind::empty_sphere) {
                const auto p = bicell_points(t, h);
                CHECK(orientation_verdict({at(p[0]), at(p[1]), at(p[2]), at(p[4])}).sign > 0);
                CHECK(orientation_verdict({at(p[1]), at(p[0]), at(p[2]), at(p[3])}).sign > 0);
                CHECK(empty_sphere_verdict({at(p[0]), at(p[1]), at(p[2]), at(p[3]), at(p[4])}).sign > 0);
            } else if (kind == Facet_kind::ridge) {
                ++ridges;
                const auto p = ridge_vertex_last(t, h, ridge_points(t, h));
                CHECK(p[2] == t.vertex(h));
                CHECK(p[3] == t.vertex(t.twin(h)));
                CHECK(orientation_verdict({at(p[0]), at(p[1]), at(p[2]), at(p[3])}).sign > 0);
            } else {
                const auto p = slab_points(t, h);
                CHECK(orientation_verdict({at(p[0]), at(p[1]), at(p[2]), at(p[3])}).sign > 0);
            }
        }
    }
    CHECK(ridges > 10);
}
