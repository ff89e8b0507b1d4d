// SPDX-License-Identifier: GPL-3.0-or-later
// 3D flips in the table and in CGAL's object, which follows: made and undone.
#include <annulus/internal/view_3.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/mesh/replace_cells.h>
#include <annulus/mesh/table_flips_3.h>
#include <annulus/predicate/filtered.h>

#include <common/cells.h>

#include <support/catch.h>
#include <support/point_sets_3.h>

using namespace annulus;
using namespace annulus::testing;

namespace {

using Cell_list_3 = oracle::Cells_of<3>;

/// Every cell of the table, sorted within and among themselves: a triangulation whatever its numbers.
Cell_list_3 cells_of_table(const Corner_table<3>& t) {
    Cell_list_3 cells;
    for (const Cell_index c : t.cells()) {
        auto x = cell_vertices(t, c);
        std::sort(x.begin(), x.end());
        cells.push_back(x);
    }
    std::sort(cells.begin(), cells.end());
    return cells;
}

/// A view that is updated after flips.
void check_same(const Delaunay_mesh<3>& e, Cgal_view_3<No_info>& view, const Points_3& x) {
    view.invalidate_cells();
    const auto& tr = view.update(x);
    CHECK(tr.tds().is_valid());
    for (auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
        for (int i = 0; i <= 3; ++i) {
            const Corner_index h = e.table().corner(Cell_index(c->cell()), i);
            REQUIRE(e.table().vertex(h) == (tr.is_infinite(c->vertex(i)) ? infinite : c->vertex(i)->index()));
            REQUIRE(e.table().twin(h) ==
                    e.table().corner(Cell_index(c->neighbor(i)->cell()), tr.tds().mirror_index(c, i)));
            REQUIRE(e.table().facet(h) == e.table().facet(e.table().twin(h)));
            REQUIRE(e.table().is_facet(e.table().facet(h)));
        }
}

Cell_vertices<3> vertices_of(const Cell_sites<3>& x) { return {x[0].vertex, x[1].vertex, x[2].vertex, x[3].vertex}; }

bool has_all(const Corner_table<3>& t, Cell_index c, std::initializer_list<Index> vertices) {
    return std::all_of(vertices.begin(), vertices.end(), [&](Index v) { return t.slot(c, Site<3>(v)) >= 0; });
}

bool is_edge(const Corner_table<3>& t, Index p, Index q) {
    for (const Cell_index c : t.cells())
        if (has_all(t, c, {p, q})) return true;
    return false;
}

bool is_facet(const Corner_table<3>& t, Index p, Index q, Index r) {
    for (const Cell_index c : t.cells())
        if (has_all(t, c, {p, q, r})) return true;
    return false;
}

/// The cells of the table without some and with others, in the form of cells_of_table.
Cell_list_3 exchanged(Cell_list_3 cells, const Cell_list_3& gone, const Cell_list_3& came) {
    for (auto x : gone) {
        std::sort(x.begin(), x.end());
        const auto it = std::find(cells.begin(), cells.end(), x);
        REQUIRE(it != cells.end());
        cells.erase(it);
    }
    for (auto x : came) {
        std::sort(x.begin(), x.end());
        cells.push_back(x);
    }
    std::sort(cells.begin(), cells.end());
    return cells;
}

/// Whether the two orders of corners are the same but for an even permutation.
bool same_orientation(const Cell_sites<3>& x, const Cell_sites<3>& y) {
    int inversions = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j)
            if (std::find(y.begin(), y.end(), x[i]) > std::find(y.begin(), y.end(), x[j])) ++inversions;
    return inversions % 2 == 0;
}

/// Both sides of every facet see its vertices turn in opposite directions.
void check_orientations(const Corner_table<3>& t) {
    for (const Corner_index f : t.facets()) {
        Cell_sites<3> one = facet_and_vertex(t, f);
        Cell_sites<3> other = facet_and_vertex(t, t.twin(f));
        one[3] = other[3] = Site<3>(none);
        REQUIRE_FALSE(same_orientation(one, other));
    }
}

}  // namespace

TEST_CASE("Every flip of the table makes the cells it should, oriented, and CGAL's object follows", "[flips][space]") {
    std::array<int, 3> made{};
    for (const Set_3 set : {Set_3::uniform, Set_3::lattice, Set_3::sphere}) {
        Random random(17);
        Delaunay_mesh<3> e;
        const Points_3 places = point_set(set, 30, random);
        e.build(places);
        REQUIRE(e.dimension() == 3);
        Cgal_view_3<No_info> view(e, places);
        auto& t = e.table();
        for (int attempt = 0; attempt < 900; ++attempt) {
            const Cell_index cell(static_cast<Index>(random() % t.cell_bound().offset()));
            if (!t.is_cell(cell)) continue;
            const Corner_index h = t.corner(cell, static_cast<int>(random() % 4));
            const Corner_index k =
                t.corner(cell, static_cast<int>((static_cast<std::size_t>(t.slot_of(h)) + 1 + random() % 3) % 4));
            const auto [a, b, c, q] = vertices_of(facet_and_vertex(t, h));
            const Index p = t.vertex(t.twin(h));
            const Cell_list_3 before = cells_of_table(t);
            const std::size_t kind = random() % 3;
            std::array<Cell_index, 3> cells{};
            if (kind == 0) {
                if (is_edge(t, p, q)) continue;
                REQUIRE(flip_facet(t, h, cells));
                CHECK(cells_of_table(t) ==
                      exchanged(before, {{a, b, c, q}, {a, b, c, p}}, {{a, b, p, q}, {b, c, p, q}, {c, a, p, q}}));
            } else if (kind == 1) {
                Cell_vertices<3> x = vertices_of(facet_and_vertex(t, h));
                while (x[2] != t.vertex(k)) x = {x[1], x[2], x[0], x[3]};
                if (is_facet(t, x[2], p, q) || !flip_edge(t, h, k, cells)) {
                    CHECK(cells_of_table(t) == before);
                    continue;
                }
                CHECK_FALSE(t.is_cell(cells[2]));
                CHECK(cells_of_table(t) == exchanged(before, {{a, b, c, q}, {a, b, c, p}, {x[0], x[1], p, q}},
                                                     {{x[2], p, q, x[0]}, {x[2], p, q, x[1]}}));
            } else {
                const auto flip = flip_4_4(t, h, k);
                if (!flip || is_edge(t, p, q)) continue;
                Cell_list_3 gone;
                for (const Cell_index g : flip->gone) gone.push_back(cell_vertices(t, g));
                std::vector<Cell_index> touched;
                replace_cells<3>(t, flip->gone, flip->came, touched);
                Cell_list_3 came;
                for (const Cell_sites<3>& x : flip->came) came.push_back(vertices_of(x));
                CHECK(cells_of_table(t) == exchanged(before, gone, came));
            }
            ++made[kind];
            check_orientations(t);
            check_same(e, view, places);
        }
    }
    for (const int n : made) CHECK(n > 10);
}

TEST_CASE("Flips of any signs keep the table a manifold", "[flips][space]") {
    // Edges and facets may occur twice; a cell adjacent to itself would no longer be a flip of a ball.
    int refused = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Random random(seed);
        Delaunay_mesh<3> e;
        e.build(point_set(Set_3::uniform, 5 + static_cast<std::size_t>(seed % 4), random));
        auto& t = e.table();
        for (int attempt = 0; attempt < 200; ++attempt) {
            const Cell_index cell(static_cast<Index>(random() % t.cell_bound().offset()));
            if (!t.is_cell(cell)) continue;
            const Corner_index h = t.corner(cell, static_cast<int>(random() % 4));
            const Corner_index k =
                t.corner(cell, static_cast<int>((static_cast<std::size_t>(t.slot_of(h)) + 1 + random() % 3) % 4));
            std::array<Cell_index, 3> cells{};
            if (!(random() % 2 == 0 ? flip_facet(t, h, cells) : flip_edge(t, h, k, cells))) ++refused;
            for (const Cell_index c : t.cells())
                for (int i = 0; i <= 3; ++i) {
                    const Corner_index twin = t.twin(t.corner(c, i));
                    REQUIRE(t.cell_of(twin) != c);
                    REQUIRE(t.is_cell(t.cell_of(twin)));
                    REQUIRE(t.twin(twin) == t.corner(c, i));
                }
            check_orientations(t);
        }
    }
    CHECK(refused > 100);
}

TEST_CASE("A flip of the table is undone by its opposite", "[flips][space]") {
    Random random(31);
    Delaunay_mesh<3> e;
    e.build(point_set(Set_3::uniform, 40, random));
    auto& t = e.table();
    const Cell_list_3 before = cells_of_table(t);
    int undone = 0;
    for (Corner_index h(0); h < t.facet_bound(); ++h) {  // flips change the numbers
        if (!t.is_facet(h)) continue;
        const Index q = t.vertex(h);
        if (is_edge(t, t.vertex(t.twin(h)), q)) continue;
        std::array<Cell_index, 3> three{};
        REQUIRE(flip_facet(t, h, three));
        // The facet of two of the three, seen from the first; what lies opposite to the new edge is its corner 0 or 1.
        const Corner_index inner = t.corner(three[0], 0);
        const Corner_index third = t.corner(three[0], 1);
        std::array<Cell_index, 3> two{};
        REQUIRE(flip_edge(t, inner, third, two));
        REQUIRE(cells_of_table(t) == before);
        check_orientations(t);
        ++undone;
    }
    CHECK(undone > 20);
}

TEST_CASE("The corners of a ridge and of a bi-cell are in the order that the certificates take", "[flips][space]") {
    Random random(29);
    Delaunay_mesh<3> e;
    const Points_3 x = point_set(Set_3::uniform, 60, random);
    e.build(x);
    const auto& t = e.table();
    const auto at = [&](Site<3> s) { return &x[static_cast<std::size_t>(s.vertex)]; };
    int ridges = 0;
    for (const Corner_index f : t.facets()) {
        for (const Corner_index h : {f, t.twin(f)}) {
            const Facet_kind kind = facet_kind(t, h);
            if (kind == Facet_kind::empty_sphere) {
                const auto p = bicell_sites(t, h);
                CHECK(evaluate_orientation({at(p[0]), at(p[1]), at(p[2]), at(p[4])}).sign > 0);
                CHECK(evaluate_orientation({at(p[1]), at(p[0]), at(p[2]), at(p[3])}).sign > 0);
                CHECK(evaluate_empty_sphere({at(p[0]), at(p[1]), at(p[2]), at(p[3]), at(p[4])}).sign > 0);
            } else if (kind == Facet_kind::ridge) {
                ++ridges;
                const auto p = ridge_vertex_last(t, h, ridge_sites(t, h));
                CHECK((p[2] == t.site(h)));
                CHECK((p[3] == t.opposite(h)));
                CHECK(evaluate_orientation({at(p[0]), at(p[1]), at(p[2]), at(p[3])}).sign > 0);
            } else {
                const auto p = slab_sites(t, h);
                CHECK(evaluate_orientation({at(p[0]), at(p[1]), at(p[2]), at(p[3])}).sign > 0);
            }
        }
    }
    CHECK(ridges > 10);
}
