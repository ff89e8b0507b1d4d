// SPDX-License-Identifier: GPL-3.0-or-later
// What Moving_mesh lists: neighbours, hull and the cells of points follow from the cells alone, by exact signs in
// rational numbers; lists are kept until a cell changes, and no longer.
#include <annulus/moving_mesh.h>

#include <support/catch.h>
#include <support/generators_3.h>
#include <support/meshes.h>
#include <support/repeats.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

int orientation(const std::array<Coordinates<2>, 3>& x) { return exact_orientation(x[0], x[1], x[2]); }
int orientation(const std::array<Coordinates<3>, 4>& x) { return exact_orientation(x[0], x[1], x[2], x[3]); }

template <int d>
using Corners = std::array<Coordinates<d>, static_cast<std::size_t>(d) + 1>;

template <int d>
Corners<d> corners_of(const Moving_mesh<d>& mesh, const std::array<Index, static_cast<std::size_t>(d) + 1>& cell) {
    Corners<d> x;
    for (std::size_t i = 0; i < cell.size(); ++i) x[i] = mesh.points()[static_cast<std::size_t>(cell[i])];
    return x;
}

/// Whether p is in the closed cell.
template <int d>
bool holds(const Corners<d>& cell, const Coordinates<d>& p) {
    for (std::size_t i = 0; i < cell.size(); ++i) {
        Corners<d> x = cell;
        x[i] = p;
        if (orientation(x) < 0) return false;
    }
    return true;
}

template <int d>
void check_lists(const Moving_mesh<d>& mesh, Random& random) {
    const auto cells = mesh.cells();
    const auto lists = mesh.cell_lists();
    REQUIRE(lists->cells.vertices == cells.vertices);
    REQUIRE(lists->cells.neighbours == cells.neighbours);
    const bool full = mesh.dimension() == d;

    std::vector<std::set<Index>> around(mesh.index_bound());
    std::map<std::set<Index>, int> facets;
    std::vector<Index> first(mesh.index_bound(), -1);
    for (std::size_t c = 0; c < cells.vertices.size(); ++c)
        for (const Index v : cells.vertices[c]) {
            if (v < 0) continue;
            if (full && first[static_cast<std::size_t>(v)] < 0)
                first[static_cast<std::size_t>(v)] = static_cast<Index>(c);
            std::set<Index> facet;
            for (const Index w : cells.vertices[c])
                if (w >= 0 && w != v) around[static_cast<std::size_t>(v)].insert(w), facet.insert(w);
            ++facets[facet];
        }
    CHECK(lists->cell_of == first);
    for (Index v = 0; v < static_cast<Index>(mesh.index_bound()); ++v) {
        const auto& expected = around[static_cast<std::size_t>(v)];
        const std::vector<Index> all(expected.begin(), expected.end());
        const auto of = mesh.vertex_neighbors()->of(v);
        CHECK(std::vector<Index>(of.begin(), of.end()) == all);
        if (!mesh.is_vertex(v)) {
            CHECK(all.empty());
            CHECK_THROWS_AS(mesh.neighbors(v), Error);
            continue;
        }
        const auto neighbors = mesh.neighbors(v);
        CHECK(std::vector<Index>(neighbors.begin(), neighbors.end()) == all);
    }

    const auto hull = mesh.convex_hull();
    std::size_t on_hull = 0;
    for (const auto& [facet, count] : facets) on_hull += full && count == 1 ? 1U : 0U;
    CHECK(hull.size() == on_hull);
    std::set<std::set<Index>> listed;
    for (const auto& facet : hull) {
        listed.emplace(facet.begin(), facet.end());
        CHECK(facets[std::set<Index>(facet.begin(), facet.end())] == 1);
        for (std::size_t i = 0; i < mesh.index_bound(); ++i) {  // all vertices are on its inner side
            if (!mesh.is_vertex(static_cast<Index>(i))) continue;
            Corners<d> x;
            for (std::size_t k = 0; k < d; ++k) x[k] = mesh.points()[static_cast<std::size_t>(facet[k])];
            x[d] = mesh.points()[i];
            CHECK(orientation(x) * (d == 2 ? 1 : -1) >= 0);
        }
    }
    CHECK(listed.size() == hull.size());

    std::vector<Coordinates<d>> queries;
    for (int k = 0; k < 12; ++k) {
        Coordinates<d> p;
        for (double& c : p) c = between(random, -0.5, 4.5);
        if (k % 3 == 0)
            for (double& c : p) c = std::round(c);
        queries.push_back(p);
    }
    for (std::size_t i = 0; i < mesh.index_bound(); i += 3)
        if (mesh.is_vertex(static_cast<Index>(i))) queries.push_back(mesh.points()[i]);
    queries.push_back({std::numeric_limits<double>::quiet_NaN(), 0});
    queries.push_back({HUGE_VAL, 0});
    queries.push_back({std::numeric_limits<double>::max(), 0});
    const auto found = mesh.find_cells(queries);
    for (std::size_t k = 0; k < queries.size(); ++k) {
        bool inside = false;
        if (full && std::fabs(queries[k][0]) < 0x1p500)
            for (const auto& cell : cells.vertices) inside = inside || holds<d>(corners_of(mesh, cell), queries[k]);
        for (const Index c : {found[k], mesh.find_cell(queries[k])}) {
            REQUIRE((c >= 0) == inside);
            if (inside) CHECK(holds<d>(corners_of(mesh, cells.vertices[static_cast<std::size_t>(c)]), queries[k]));
        }
    }
    CHECK(mesh.find_cells({}).empty());
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Lists follow from the cells, dimension", "[lists]", ((int d), d), 2, 3) {
    Random random(5);
    for (const Strategy strategy : {Strategy::automatic, Strategy::tolerances, Strategy::rebuild})
        for (int run = 0; run < repeats(2); ++run) {
            auto x = grid<d>();
            Moving_mesh<d> mesh(std::span<const Coordinates<d>>(x), {.strategy = strategy});
            check_lists(mesh, random);
            for (int step = 0; step < 6; ++step) {
                const double by = step % 3 == 0 ? 1e-4 : 0.2;
                for (auto& p : x)
                    for (double& c : p) c += between(random, -by, by);
                (void)mesh.move_all(x);
                check_lists(mesh, random);
                const auto i = static_cast<Index>(random() % x.size());
                x[static_cast<std::size_t>(i)][0] += 0.7;
                (void)mesh.move(i, x[static_cast<std::size_t>(i)]);
                check_lists(mesh, random);
            }
            mesh.remove(3);
            mesh.remove(7);
            check_lists(mesh, random);
            Coordinates<d> p{};
            p[0] = 9;
            (void)mesh.insert(p);
            check_lists(mesh, random);
        }
}

TEMPLATE_TEST_CASE_SIG("Lists of flat vertices, dimension", "[lists]", ((int d), d), 2, 3) {
    Random random(6);
    Moving_mesh<d> mesh;
    check_lists(mesh, random);
    CHECK(mesh.find_cell({}) == -1);
    std::vector<Coordinates<d>> x(5);
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i][0] = static_cast<double>(i);
        (void)mesh.insert(x[i]);
        check_lists(mesh, random);
    }
    CHECK(mesh.neighbors(1).size() == 2);
    // The chain of a line changes with the order of the vertices, though no cell is written.
    std::swap(x[0], x[2]);
    (void)mesh.move_all(x);
    CHECK(mesh.neighbors(2).size() == 1);
    check_lists(mesh, random);
    mesh.remove(1);
    CHECK(mesh.neighbors(0).size() == 2);
    x[1] = {};
    x[1][1] = 1;
    (void)mesh.insert(x[1]);
    check_lists(mesh, random);
    CHECK(mesh.convex_hull().empty() == (d == 3));
    (void)mesh.move(1, [&] {
        x[1][1] = 0;
        x[1][0] = -1;
        return x[1];
    }());
    check_lists(mesh, random);
    CHECK(mesh.convex_hull().empty());
}

TEMPLATE_TEST_CASE_SIG("Lists are kept until a cell changes, dimension", "[lists]", ((int d), d), 2, 3) {
    Random random(7);
    std::vector<Coordinates<d>> x(60);
    for (auto& p : x)
        for (double& c : p) c = between(random, 0, 1);
    Moving_mesh<d> mesh(std::span<const Coordinates<d>>(x), {.strategy = Strategy::tolerances});
    const auto cells = mesh.cell_lists();
    const auto neighbors = mesh.vertex_neighbors();
    const Index* const of_4 = mesh.neighbors(4).data();
    for (auto& p : x) p[0] += 1e-12;
    (void)mesh.move_all(x);
    CHECK(mesh.cell_lists() == cells);
    CHECK(mesh.vertex_neighbors() == neighbors);
    CHECK(mesh.neighbors(4).data() == of_4);
    const auto before = cells->cells.vertices;
    for (auto& p : x)
        for (double& c : p) c += between(random, -0.1, 0.1);
    const auto old = sorted_cells(mesh);
    (void)mesh.move_all(x);
    REQUIRE(sorted_cells(mesh) != old);
    CHECK(mesh.cell_lists() != cells);
    CHECK(mesh.vertex_neighbors() != neighbors);
    CHECK(cells->cells.vertices == before);  // a list that is held stays as it is
    check_lists(mesh, random);
}
