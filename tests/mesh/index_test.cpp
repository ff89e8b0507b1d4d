// SPDX-License-Identifier: GPL-3.0-or-later
// Types of indices: mix-ups do not compile, and "none" differs from every index.
#include <annulus/internal/view_2.h>
#include <annulus/internal/view_3.h>
#include <annulus/kernel/delaunay_mesh.h>

#include <support/catch.h>
#include <support/point_sets_3.h>

#include <concepts>
#include <memory>
#include <set>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <class To, class... From>
constexpr bool none_converts = (... && (!std::convertible_to<From, To> && !std::assignable_from<To&, From>));
static_assert(none_converts<Index, Cell_index, Corner_index>);
static_assert(none_converts<Cell_index, Index, Corner_index>);
static_assert(none_converts<Corner_index, Index, Cell_index>);
static_assert(!std::constructible_from<Cell_index, Corner_index> && !std::constructible_from<Corner_index, Cell_index>);
static_assert(!std::equality_comparable_with<Cell_index, Corner_index> &&
              !std::equality_comparable_with<Cell_index, Index>);

template <class Array, class I>
concept takes = requires(Array& a, I i) {
    a[i];
};
static_assert(takes<By_cell<int>, Cell_index> && takes<By_corner<int>, Corner_index>);
static_assert(!takes<By_cell<int>, Corner_index> && !takes<By_cell<int>, Index> && !takes<By_cell<int>, std::size_t>);

// "No vertex" differs from the vertex at infinity, which is -1 in arrays of the caller.
static_assert(infinite == -1 && none != infinite && none < 0);
static_assert(Cell_index() == no_cell && Corner_index() == no_corner && no_cell < Cell_index(0) &&
              no_corner < Corner_index(0));
static_assert(std::is_trivially_copyable_v<Cell_index> && sizeof(Cell_index) == 4);

}  // namespace

TEST_CASE("The cells and facets of a table are each visited once", "[mesh][index]") {
    Random random(5);
    Delaunay_mesh<3> e;
    const auto points = point_set(Set_3::uniform, 40, random);
    e.build(points);
    std::vector<Cell_index> changed;
    e.remove(points, 7, changed);  // leaves holes
    const Corner_table<3>& t = std::as_const(e).table();
    std::set<Cell_index> cells;
    std::set<Corner_index> facets;
    for (const Cell_index c : t.cells()) {
        CHECK(t.is_cell(c));
        CHECK(cells.insert(c).second);
        for (int i = 0; i <= 3; ++i) facets.insert(t.facet(t.corner(c, i)));
    }
    CHECK(cells.size() < t.cell_bound().offset());
    std::vector<Corner_index> visited;
    for (const Corner_index f : t.facets()) visited.push_back(f);
    CHECK(visited == std::vector<Corner_index>(facets.begin(), facets.end()));
    std::size_t finite = 0;
    for (const Cell_index c : t.finite_cells()) {
        CHECK(!t.is_infinite(c));
        ++finite;
    }
    std::vector<Index> corners;
    e.list_cells(points, corners);
    CHECK(finite == corners.size() / 4);
    const Corner_table<3> empty;
    for (const Cell_index c : empty.cells()) FAIL("cell " << c.value());
    for (const Corner_index f : empty.facets()) FAIL("facet " << f.value());
}

TEST_CASE("CGAL's vertex at infinity has the index of infinity, and a vertex without a place in the table no corner",
          "[mesh][index]") {
    const auto check = [](auto& e, const auto& points, auto view_of) {
        e.build(points);
        const auto view = view_of(e, points);
        CHECK(view->update(points).infinite_vertex()->index() == infinite);
        CHECK(e.table().vertex(e.table().corner_of_infinity()) == infinite);
        std::vector<Cell_index> changed;
        e.remove(points, 2, changed);
        CHECK(e.table().corner_of(2) == no_corner);
        CHECK(e.table().corner_of(1) != no_corner);
    };
    Delaunay_mesh<2> plane;
    check(plane, std::vector<Coordinates<2>>{{0, 0}, {4, 0}, {1, 1}, {0, 4}, {5, 5}, {2, 3}},
          [](auto& e, const auto& points) { return std::make_unique<Cgal_view_2<No_info>>(e, points); });
    Random random(6);
    Delaunay_mesh<3> space;
    check(space, point_set(Set_3::uniform, 20, random),
          [](auto& e, const auto& points) { return std::make_unique<Cgal_view_3<No_info>>(e, points); });
}
