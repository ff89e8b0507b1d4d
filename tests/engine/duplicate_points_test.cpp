// SPDX-License-Identifier: GPL-3.0-or-later
// The error of a duplicate point names the vertices at that position, and other errors those that they concern, for
// every call and every strategy.
#include <annulus/error.h>
#include <annulus/moving_mesh.h>

#include <support/catch.h>
#include <support/generators.h>
#include <support/viewed_mesh.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

using Names = std::vector<std::int64_t>;

struct Thrown {
    Error_code code;
    Names vertices;
    std::string words;
};

Thrown thrown_by(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& e) {
        return {e.code(), Names(e.vertices().begin(), e.vertices().end()), e.what()};
    }
    FAIL("nothing was thrown");
    return {};
}

void check_thrown(const std::function<void()>& call, Error_code code, const Names& vertices, const std::string& words) {
    const Thrown thrown = thrown_by(call);
    CHECK(thrown.code == code);
    CHECK(thrown.vertices == vertices);
    CHECK(thrown.words == words);
}

template <int d>
using Positions = std::vector<Coordinates<d>>;

/// In general position, on a lattice, and on a line.
template <int d>
std::vector<Positions<d>> point_sets() {
    Random random(8);
    Positions<d> scattered(40), lattice, line;
    for (auto& p : scattered)
        for (double& c : p) c = between(random, 0, 1);
    for (int k = 0; k < (d == 2 ? 36 : 64); ++k) {
        Coordinates<d> p{};
        const int side = d == 2 ? 6 : 4;
        for (int i = 0, rest = k; i < d; ++i, rest /= side) p[static_cast<std::size_t>(i)] = rest % side;
        lattice.push_back(p);
    }
    for (int k = 0; k < 12; ++k) {
        Coordinates<d> p{};
        p[0] = k;
        line.push_back(p);
    }
    return {scattered, lattice, line};
}

constexpr Strategy strategies[] = {Strategy::automatic,       Strategy::rebuild,  Strategy::relocate,
                                   Strategy::relocate_flips,  Strategy::in_place, Strategy::tolerances,
                                   Strategy::tolerances_each, Strategy::paper,    Strategy::paper_hybrid};

template <class Mesh, int d>
void check_everything(const Positions<d>& points, const Options& options) {
    const auto span = [](const Positions<d>& x) { return std::span<const Coordinates<d>>(x); };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Positions<d> x = points;
    x[9] = x[4];
    check_thrown([&] { Mesh mesh(span(x), options); }, Error_code::duplicate_point, {4, 9},
                 "points 4 and 9 have the same position");
    x[9] = points[9];
    x[7][1] = nan;
    check_thrown([&] { Mesh mesh(span(x), options); }, Error_code::not_finite, {7},
                 "a coordinate of point 7 is not a finite number");
    x = points;

    Mesh mesh(span(points), options);
    // Twice: with tolerances, where any are kept, and after the first refusals.
    for (int round = 0; round < 2; ++round) {
        const Error_code duplicate_point = Error_code::duplicate_point;
        check_thrown([&] { (void)mesh.move(2, points[11]); }, duplicate_point, {2, 11},
                     "vertices 2 and 11 would have the same position");
        check_thrown([&] { (void)mesh.move(11, points[2]); }, duplicate_point, {2, 11},
                     "vertices 2 and 11 would have the same position");
        const Index one[] = {5};
        check_thrown([&] { (void)mesh.move(one, std::span(&points[3], 1)); }, duplicate_point, {3, 5},
                     "vertices 3 and 5 would have the same position");
        const Index some[] = {1, 6, 8};
        const Positions<d> targets{points[8], points[10], points[1]};  // two exchange positions, one is in the way
        check_thrown([&] { (void)mesh.move(some, targets); }, duplicate_point, {6, 10},
                     "vertices 6 and 10 would have the same position");
        const Positions<d> equal{points[8], points[8], points[1]};
        check_thrown([&] { (void)mesh.move(some, equal); }, duplicate_point, {1, 6},
                     "vertices 1 and 6 would have the same position");
        x = points;
        x[10] = x[0];
        check_thrown([&] { (void)mesh.move_all(span(x)); }, duplicate_point, {0, 10},
                     "vertices 0 and 10 would have the same position");
        check_thrown([&] { (void)mesh.insert(points[7]); }, duplicate_point, {7},
                     "vertex 7 has the position of the point to be inserted");
        x = points;
        x[3][0] = 0x1p501;
        check_thrown([&] { (void)mesh.move_all(span(x)); }, Error_code::out_of_domain, {3},
                     "a coordinate of vertex 3 is larger than 2^500 in magnitude");
        check_thrown([&] { (void)mesh.move(6, x[3]); }, Error_code::out_of_domain, {6},
                     "a coordinate of vertex 6 is larger than 2^500 in magnitude");
        check_thrown([&] { (void)mesh.move(one, std::span(&x[3], 1)); }, Error_code::out_of_domain, {5},
                     "a coordinate of vertex 5 is larger than 2^500 in magnitude");
        check_thrown([&] { (void)mesh.move(1000, points[0]); }, Error_code::unknown_vertex, {1000},
                     "no vertex has index 1000");
        CHECK(Positions<d>(mesh.points().begin(), mesh.points().end()) == points);
        CHECK(mesh.audit().delaunay());
    }
    // The position of a removed vertex is free for others, and no error names a free index.
    mesh.remove(4);
    check_thrown([&] { (void)mesh.move(4, points[0]); }, Error_code::unknown_vertex, {4}, "no vertex has index 4");
    const Index unknown[] = {1000, 3, 4, 1000, -1};
    const Positions<d> anywhere(5, points[0]);
    check_thrown([&] { (void)mesh.move(unknown, anywhere); }, Error_code::unknown_vertex, {-1, 4, 1000},
                 "no vertex has index -1; 2 more are refused");
    check_thrown([&] { (void)mesh.move(std::span(unknown).first(3), std::span(anywhere).first(3)); },
                 Error_code::unknown_vertex, {4, 1000}, "no vertex has index 4; 1 more is refused");
    x = points;
    x[8] = points[4];
    (void)mesh.move_all(span(x));
    x[9] = points[4];
    check_thrown([&] { (void)mesh.move_all(span(x)); }, Error_code::duplicate_point, {8, 9},
                 "vertices 8 and 9 would have the same position");
    CHECK(mesh.audit().delaunay());
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Every duplicate point names both vertices, dimension", "[errors]", ((int d), d), 2, 3) {
    for (const Positions<d>& points : point_sets<d>())
        for (const Strategy strategy : strategies)
            for (const bool listing : {false, true}) {
                Options options;
                options.strategy = strategy;
                options.report_changes = listing;
                INFO(std::string(name_of(strategy))
                     << ", " << points.size() << " points" << (listing ? ", changes listed" : ""));
                check_everything<Moving_mesh<d>, d>(points, options);
                check_everything<testing::Viewed_mesh<d>, d>(points, options);
            }
}

TEMPLATE_TEST_CASE_SIG("Few vertices of many, -0 for 0, and the pair that is named where several collide, dimension",
                       "[errors]", ((int d), d), 2, 3) {
    Random random(9);
    Positions<d> points(400);
    for (auto& p : points)
        for (double& c : p) c = between(random, -1, 1);
    points[30][0] = 0.0;
    for (const Strategy strategy : strategies) {
        Options options;
        options.strategy = strategy;
        INFO(std::string(name_of(strategy)));
        Moving_mesh<d> mesh(std::span<const Coordinates<d>>(points), options);
        (void)mesh.recompute_tolerances();
        const Index some[] = {17, 200};
        Positions<d> targets{points[30], points[30]};
        targets[0][0] = -0.0;
        targets[1] = points[200];
        check_thrown([&] { (void)mesh.move(some, targets); }, Error_code::duplicate_point, {17, 30},
                     "vertices 17 and 30 would have the same position");
        check_thrown([&] { (void)mesh.insert(targets[0]); }, Error_code::duplicate_point, {30},
                     "vertex 30 has the position of the point to be inserted");
        Positions<d> x = points;
        for (std::size_t i = 100; i < 110; ++i) x[i + 50] = x[i];
        const Thrown thrown = thrown_by([&] { (void)mesh.move_all(std::span<const Coordinates<d>>(x)); });
        REQUIRE(thrown.vertices.size() == 2);
        CHECK(thrown.vertices[0] + 50 == thrown.vertices[1]);
        CHECK(x[static_cast<std::size_t>(thrown.vertices[0])] == x[static_cast<std::size_t>(thrown.vertices[1])]);
    }
}

// vertices() has all of them.
TEMPLATE_TEST_CASE_SIG("The text of a duplicate point has eight indices and counts the rest, dimension", "[errors]",
                       ((int d), d), 2, 3) {
    Random random(10);
    Positions<d> points(60);
    for (auto& p : points)
        for (double& c : p) c = between(random, -1, 1);
    const auto text = [](const char* what, std::size_t many, const char* have) {
        std::string words = what;
        for (std::size_t k = 0; k < std::min<std::size_t>(many, 8); ++k)
            words += (k == 0 ? " " : k + 1 == many ? " and " : ", ") + std::to_string(3 + 5 * k);
        if (many > 8) words += " and " + std::to_string(many - 8) + " more";
        return words + " " + have + " the same position";
    };
    CHECK(text("points", 2, "have") == "points 3 and 8 have the same position");
    CHECK(text("points", 8, "have") == "points 3, 8, 13, 18, 23, 28, 33 and 38 have the same position");
    CHECK(text("points", 9, "have") == "points 3, 8, 13, 18, 23, 28, 33, 38 and 1 more have the same position");
    for (const std::size_t many : {2U, 3U, 7U, 8U, 9U, 10U, 12U}) {
        Positions<d> x = points;
        Names names;
        for (std::size_t k = 0; k < many; ++k) {
            x[3 + 5 * k] = points[3];
            names.push_back(static_cast<std::int64_t>(3 + 5 * k));
        }
        const std::span<const Coordinates<d>> to(x);
        check_thrown([&] { Moving_mesh<d> mesh(to); }, Error_code::duplicate_point, names,
                     text("points", many, "have"));
        Moving_mesh<d> mesh{std::span<const Coordinates<d>>(points)};
        check_thrown([&] { (void)mesh.move_all(to); }, Error_code::duplicate_point, names,
                     text("vertices", many, "would have"));
    }
}
