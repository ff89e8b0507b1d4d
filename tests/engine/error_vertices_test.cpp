// SPDX-License-Identifier: GPL-3.0-or-later
// An error names all vertices concerned, by the caller's numbers: a table of calls. rules_test.cpp has other rules that
// hold in every language.
#include <annulus/error.h>
#include <annulus/predicates.h>
#include <annulus/voronoi.h>
#include <engine/rules.h>

#include <support/catch.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace annulus;
using namespace annulus::testing;
using namespace annulus::testing::rules;

namespace {

void check_error(const char* what, const std::function<void()>& call, Error_code code,
                 const std::vector<std::int64_t>& vertices) {
    CAPTURE(what);
    try {
        call();
        FAIL("nothing was thrown");
    } catch (const Error& e) {
        CHECK(e.code() == code);
        CHECK(std::vector<std::int64_t>(e.vertices().begin(), e.vertices().end()) == vertices);
    }
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("An error names all vertices concerned, dimension", "[rules]", ((int d), d), 2, 3) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Positions<d> x = some_points<d>(40, 5);
    const auto with = [&](std::initializer_list<std::pair<int, Coordinates<d>>> changes) {
        Positions<d> y = x;
        for (const auto& [i, p] : changes) y[static_cast<std::size_t>(i)] = p;
        return y;
    };
    const auto filled = [](double c) {
        Coordinates<d> p{};
        p.fill(c);
        return p;
    };
    for (const Strategy strategy : strategies) {
        INFO(std::string(name_of(strategy)));
        Moving_mesh<d> mesh(span_of<d>(x), {.strategy = strategy});
        mesh.remove(6);
        const auto move = [&mesh](std::vector<Index> indices, Positions<d> to) { (void)mesh.move(indices, to); };
        const auto build = [&](const Positions<d>& y) { (void)Moving_mesh<d>(span_of<d>(y), {.strategy = strategy}); };
        struct Row {
            const char* what;
            std::function<void()> call;
            Error_code code;
            std::vector<std::int64_t> vertices;
        };
        for (const Row& row : std::vector<Row>{
                 {"two points",
                  [&] {
                      build(with({{9, x[4]}}));
                  },
                  Error_code::duplicate_point,
                  {4, 9}},
                 {"three points",
                  [&] {
                      build(with({{9, x[4]}, {2, x[4]}}));
                  },
                  Error_code::duplicate_point,
                  {2, 4, 9}},
                 {"NaN and infinity",
                  [&] {
                      build(with({{9, filled(nan)}, {5, filled(-HUGE_VAL)}}));
                  },
                  Error_code::not_finite,
                  {5, 9}},
                 {"far and NaN",
                  [&] {
                      build(with({{9, filled(nan)}, {5, filled(0x1p501)}}));
                  },
                  Error_code::out_of_domain,
                  {5, 9}},
                 {"all: two",
                  [&] {
                      (void)mesh.move_all(with({{9, x[4]}}));
                  },
                  Error_code::duplicate_point,
                  {4, 9}},
                 {"all: three",
                  [&] {
                      (void)mesh.move_all(with({{9, x[4]}, {30, x[4]}}));
                  },
                  Error_code::duplicate_point,
                  {4, 9, 30}},
                 {"all: far",
                  [&] {
                      (void)mesh.move_all(with({{9, filled(1e200)}, {6, filled(nan)}, {7, filled(nan)}}));
                  },
                  Error_code::not_finite,
                  {7, 9}},
                 {"some: two", [&] { move({5}, {x[3]}); }, Error_code::duplicate_point, {3, 5}},
                 {"some: three",
                  [&] {
                      move({5, 8}, {x[3], x[3]});
                  },
                  Error_code::duplicate_point,
                  {3, 5, 8}},
                 {"some: NaN",
                  [&] {
                      move({8, 5, 1}, {filled(nan), filled(nan), x[0]});
                  },
                  Error_code::not_finite,
                  {5, 8}},
                 {"some: NaN twice",
                  [&] {
                      move({8, 8}, {filled(nan), filled(nan)});
                  },
                  Error_code::not_finite,
                  {8}},
                 {"some: unknown",
                  [&] {
                      move({6, 1, -1, 99, 6}, Positions<d>(5, x[0]));
                  },
                  Error_code::unknown_vertex,
                  {-1, 6, 99}},
                 {"some: sizes",
                  [&] {
                      move({1, 2}, {x[0]});
                  },
                  Error_code::wrong_size,
                  {}},
                 {"one: NaN", [&] { (void)mesh.move(3, filled(nan)); }, Error_code::not_finite, {3}},
                 {"one: taken", [&] { (void)mesh.move(3, x[8]); }, Error_code::duplicate_point, {3, 8}},
                 {"one: unknown", [&] { (void)mesh.move(6, x[0]); }, Error_code::unknown_vertex, {6}},
                 {"insert: taken", [&] { (void)mesh.insert(x[7]); }, Error_code::duplicate_point, {7}},
                 {"insert: NaN", [&] { (void)mesh.insert(filled(nan)); }, Error_code::not_finite, {}},
                 {"remove", [&] { mesh.remove(6); }, Error_code::unknown_vertex, {6}},
                 {"tolerance", [&] { (void)mesh.tolerance(6); }, Error_code::unknown_vertex, {6}},
                 {"fixed_position", [&] { (void)mesh.fixed_position(-1); }, Error_code::unknown_vertex, {-1}},
                 {"displacement", [&] { (void)mesh.displacement(40); }, Error_code::unknown_vertex, {40}},
                 {"theta", [&] { (void)mesh.theta(6); }, Error_code::unknown_vertex, {6}},
                 {"neighbors", [&] { (void)mesh.neighbors(6); }, Error_code::unknown_vertex, {6}}})
            check_error(row.what, row.call, row.code, row.vertices);
        CHECK(mesh.audit().delaunay());
    }
    // On a line, which no strategy repairs.
    Positions<d> line(6);
    for (std::size_t i = 0; i < line.size(); ++i) line[i].fill(static_cast<double>(i));
    Moving_mesh<d> flat(span_of<d>(line));
    line[1] = line[3] = line[5];
    check_error("flat", [&] { (void)flat.move_all(span_of<d>(line)); }, Error_code::duplicate_point, {1, 3, 5});
}

TEST_CASE("An error of a function without a mesh names what is concerned", "[rules]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    using Row = std::array<Coordinates<2>, 3>;
    const std::vector<Row> rows{
        {{{0, 0}, {1, 0}, {0, 1}}}, {{{0, nan}, {1, 0}, {0, 1}}}, {{{0, 0}, {1, 0}, {0, 1e300}}}};
    std::vector<Certified_sign> signs(3);
    check_error("rows", [&] { orient_2d(rows, signs); }, Error_code::not_finite, {1, 2});
    check_error("points",
                [] {
                    (void)orient_2d({0, 0}, {1e300, 0}, {0, HUGE_VAL});
                },
                Error_code::out_of_domain, {1, 2});
    const std::vector<Coordinates<2>> points{{0, 0}, {nan, 0}, {0, 1}, {0, HUGE_VAL}};
    const std::vector<std::array<Index, 3>> cells{{0, 1, 2}};
    check_error("audit", [&] { (void)audit(points, cells); }, Error_code::not_finite, {1, 3});
    // A cell that is turned over, and one that names no point.
    Positions<2> x{{0, 0}, {0, 1}, {1, 0}};
    Mesh_cells<2> over{{{0, 1, 2}}, {{-1, -1, -1}}};
    check_error("voronoi", [&] { (void)voronoi_volumes<2>(x, over); }, Error_code::bad_input, {0, 1, 2});
    over.vertices[0] = {0, 1, 3};
    check_error("voronoi", [&] { (void)voronoi_volumes<2>(x, over); }, Error_code::unknown_vertex, {3});
    check_error("neighbours", [&] { (void)voronoi_neighbour_counts<2>(3, over); }, Error_code::unknown_vertex, {3});
}

TEST_CASE("Positions that coincide unnoticed are all named when they are found", "[rules]") {
    Positions<2> x = some_points<2>(40, 6);
    Moving_mesh<2> mesh(span_of<2>(x), {.strategy = Strategy::paper, .tolerance = Tolerance_kind::floating});
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 2; ++k) x[10 + i][k] = 0.5 + 1e-12 * static_cast<double>(i == k);
    (void)mesh.move_all(span_of<2>(x));
    (void)mesh.recompute_tolerances();
    check_error("move",
                [&] {
                    x[10] = x[11] = x[12];
                    (void)mesh.move_all(span_of<2>(x));
                    (void)mesh.recompute_tolerances();
                },
                Error_code::duplicate_point, {10, 11, 12});
}
