// SPDX-License-Identifier: GPL-3.0-or-later
// Rules that hold in every language, as tables: what there is at a free index, what `threads` may be, defaults, the
// audit of a single point. error_vertices_test.cpp has which vertices an error names; tests/c/rules.c and
// python/tests/test_rules.py are the same tables.
#include <engine/rules.h>

#include <support/catch.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

using namespace annulus;
using namespace annulus::testing;
using namespace annulus::testing::rules;

namespace {

template <int d>
bool is_nan(const Coordinates<d>& p) {
    return std::all_of(p.begin(), p.end(), [](double c) { return std::isnan(c); });
}

template <int d>
struct Quantity {
    const char* name;
    std::function<bool(const Moving_mesh<d>&, Index)> is_absent;
};

/// What every quantity by vertex is at a free index.
template <int d>
std::vector<Quantity<d>> quantities() {
    using Mesh = Moving_mesh<d>;
    const auto at = [](Index i) { return static_cast<std::size_t>(i); };
    return {
        {"points", [=](const Mesh& m, Index i) { return is_nan<d>(m.points()[at(i)]); }},
        {"delaunay_positions", [=](const Mesh& m, Index i) { return is_nan<d>(m.delaunay_positions()[at(i)]); }},
        {"tolerances", [=](const Mesh& m, Index i) { return std::isnan(m.tolerances()[at(i)]); }},
        {"measure", [=](const Mesh& m, Index i) { return std::isnan(m.measure().tolerance[at(i)]); }},
        {"voronoi_volumes", [=](const Mesh& m, Index i) { return std::isnan(m.voronoi_volumes()[at(i)]); }},
        {"cell_of", [=](const Mesh& m, Index i) { return m.cell_lists()->cell_of[at(i)] == -1; }},
        {"vertex_neighbors", [=](const Mesh& m, Index i) { return m.vertex_neighbors()->of(i).empty(); }},
        {"is_vertex", [=](const Mesh& m, Index i) { return !m.is_vertex(i); }},
    };
}

template <int d>
void check_free(const Moving_mesh<d>& mesh, const std::vector<Index>& free, const char* when) {
    for (const auto& q : quantities<d>())
        for (Index i = 0; static_cast<std::size_t>(i) < mesh.index_bound(); ++i) {
            CAPTURE(q.name, i, when, name_of(mesh.options().strategy));
            CHECK(q.is_absent(mesh, i) == (std::find(free.begin(), free.end(), i) != free.end()));
        }
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("A free index has NaN, no neighbours and no cell, dimension", "[rules]", ((int d), d), 2, 3) {
    for (const Strategy strategy : strategies)
        for (const bool lists : {false, true}) {
            Positions<d> x = some_points<d>(40, 1);
            Moving_mesh<d> mesh(span_of<d>(x), {.strategy = strategy, .report_changes = lists});
            check_free(mesh, {}, "after construction");
            mesh.remove(4);
            mesh.remove(9);
            check_free(mesh, {4, 9}, "after removals");
            for (auto& p : x) p[0] += 1e-9;
            (void)mesh.move_all(span_of<d>(x));
            check_free(mesh, {4, 9}, "after a small step with numbers at free indices");
            for (auto& p : x) p[0] += 0.3 * p[1];
            (void)mesh.move_all(span_of<d>(x));
            check_free(mesh, {4, 9}, "after a large step");
            (void)mesh.move_all(mesh.points());
            check_free(mesh, {4, 9}, "after a step to points()");
            const Index some[] = {1, 2};
            (void)mesh.move(some, std::span(&x[1], 2));
            CHECK_THROWS_AS(mesh.insert(x[7]), Error);
            check_free(mesh, {4, 9}, "after a refused insertion");
            (void)mesh.recompute_tolerances();
            CHECK(mesh.insert(some_points<d>(1, 2)[0]) == 9);
            check_free(mesh, {4}, "after an insertion");
            CHECK(mesh.audit().delaunay());
        }
}

TEST_CASE("threads are 1 or more", "[rules]") {
    const Positions<2> x = some_points<2>(20, 3);
    for (const auto& [threads, allowed] : {std::pair(1, true),
                                           {2, true},
                                           {7, true},
                                           {0, false},
                                           {-1, false},
                                           {-3, false},
                                           {std::numeric_limits<int>::min(), false}}) {
        CAPTURE(threads);
        const Options options{.threads = threads};
        const auto make = [&] { return Moving_mesh<2>(span_of<2>(x), options).options().threads; };
        if (allowed) CHECK(make() == threads);
        else CHECK_THROWS_AS(make(), Error);
    }
}

TEST_CASE("Defaults are those of every language", "[rules]") {
    const Options defaults;
    CHECK(name_of(defaults.strategy) == "auto");
    CHECK(name_of(defaults.tolerance) == "certified");
    CHECK(defaults.threads == 1);
    CHECK(!defaults.merge_duplicates);
    CHECK(!defaults.report_changes);
    CHECK(defaults.seed == 0);
    Positions<2> x = some_points<2>(30, 4);
    Moving_mesh<2> mesh(span_of<2>(x));
    for (auto& p : x) p[0] += 0.3 * p[1] * p[1];
    const Move_result r = mesh.move_all(span_of<2>(x));
    CHECK((r.statistics.flips > 0 || r.moves.rebuilt > 0));
    CHECK((r.changed.empty() && r.gone.empty()));
}

TEMPLATE_TEST_CASE_SIG("A single point is Delaunay without cells, and with no others, dimension", "[rules]",
                       ((int d), d), 2, 3) {
    using Cell = std::array<Index, static_cast<std::size_t>(d + 1)>;
    const auto cell = [](std::initializer_list<Index> corners) {
        Cell c{};
        c.fill(none);
        std::copy(corners.begin(), corners.end(), c.begin());
        return c;
    };
    struct Row {
        std::size_t points;
        std::vector<Cell> cells;
        bool delaunay;
    };
    for (const Row& row : {Row{0, {}, true}, Row{1, {}, true}, Row{2, {}, false}, Row{2, {cell({0, 1})}, true},
                           Row{1, {cell({0})}, false}, Row{1, {cell({0, 0})}, false}, Row{1, {cell({0, 1})}, false},
                           Row{0, {cell({0, 1})}, false}, Row{0, {cell({})}, false}}) {
        CAPTURE(row.points, row.cells.size());
        const Positions<d> x = some_points<d>(row.points, 12);
        const Audit_result r = audit(std::span<const Coordinates<d>>(x), std::span<const Cell>(row.cells));
        CHECK(r.delaunay() == row.delaunay);
        CHECK(r.faults.empty() == row.delaunay);
    }
    Moving_mesh<d> mesh(span_of<d>(some_points<d>(1, 13)));
    CHECK((mesh.cells().vertices.empty() && mesh.audit().delaunay()));
    mesh.remove(0);
    CHECK((mesh.cells().vertices.empty() && mesh.audit().delaunay()));
}
