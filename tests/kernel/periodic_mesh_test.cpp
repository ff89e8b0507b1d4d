// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic_mesh: the same triangulation whatever images, basis, numbers and threads; what moves and errors do.
#include <annulus/error.h>
#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/failing_new.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <tuple>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
using Edges = std::set<std::tuple<Index, Index, Coordinates<d>>>;

/// Edges by their vectors, which do not depend on images and bases; `number` renames vertices. Every entry of the list
/// is consistent with points() and box(), which are exact here.
template <int d>
Edges<d> edges_of(const Periodic_mesh<d>& mesh, const std::vector<Index>& number = {}) {
    Edges<d> edges;
    const auto list = mesh.neighbours();
    const auto name = [&](Index v) { return number.empty() ? v : number[static_cast<std::size_t>(v)]; };
    for (std::size_t k = 0; k < list.first.size(); ++k) {
        edges.emplace(name(list.first[k]), name(list.second[k]), list.vector[k]);
        for (std::size_t i = 0; i < d; ++i) {
            double x = mesh.points()[static_cast<std::size_t>(list.second[k])][i] -
                       mesh.points()[static_cast<std::size_t>(list.first[k])][i];
            for (std::size_t j = 0; j < d; ++j) x += list.shift[k][j] * mesh.box().vectors()[j][i];
            CHECK(x == list.vector[k][i]);
        }
        if (k > 0)
            CHECK(std::tie(list.first[k - 1], list.second[k - 1], list.shift[k - 1]) <
                  std::tie(list.first[k], list.second[k], list.shift[k]));
    }
    CHECK(edges.size() == list.first.size());
    for (const auto& [i, j, v] : edges) {
        Coordinates<d> back;
        for (std::size_t k = 0; k < d; ++k) back[k] = -v[k];
        CHECK(edges.contains({j, i, back}));
    }
    return edges;
}

template <int d>
void move_by(Coordinates<d>& p, const typename Box<d>::Vectors& box, const Shift<d>& times) {
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t i = 0; i < d; ++i) p[i] += times[j] * box[j][i];
}

template <int d>
void expect_one_triangulation(std::uint64_t seed, int kind, std::size_t n) {
    CAPTURE(d, seed, kind, n);
    Periodic_cases cases(seed);
    auto vectors = cases.box<d>(kind).vectors();
    for (auto& v : vectors) v = coarse(v);
    const Box<d> box(vectors);
    auto x = cases.points<d>(box, n, 1);
    for (auto& p : x) p = coarse(p);
    const Periodic_mesh<d> mesh(x, box);
    CHECK(mesh.box() == box);
    CHECK(std::equal(x.begin(), x.end(), mesh.points().begin(), mesh.points().end()));
    const Edges<d> edges = edges_of(mesh);
    // Other images.
    auto moved = x;
    for (auto& p : moved) {
        Shift<d> times;
        for (auto& t : times) t = static_cast<std::int32_t>(cases.below(5)) - 2;
        move_by<d>(p, vectors, times);
    }
    CHECK(edges_of(Periodic_mesh<d>(moved, box)) == edges);
    // Another basis of the lattice, also a left-handed one.
    auto basis = vectors;
    for (std::size_t i = 0; i < d; ++i) basis[0][i] -= basis[1][i];
    for (std::size_t i = 0; i < d; ++i) basis[d - 1][i] += basis[0][i];
    std::swap(basis[0], basis[1]);
    CHECK(edges_of(Periodic_mesh<d>(x, Box<d>(basis))) == edges);
    for (double& c : basis[1]) c = -c;
    CHECK(edges_of(Periodic_mesh<d>(moved, Box<d>(basis))) == edges);
    // Other numbers.
    std::vector<Index> number(n);
    std::iota(number.begin(), number.end(), Index{0});
    for (std::size_t k = n; k > 1; --k) std::swap(number[k - 1], number[cases.below(k)]);
    auto renamed = x;
    for (std::size_t k = 0; k < n; ++k) renamed[k] = x[static_cast<std::size_t>(number[k])];
    CHECK(edges_of(Periodic_mesh<d>(renamed, box), number) == edges);
    // After moves.
    Periodic_mesh<d> walker(cases.points<d>(box, n), cases.box<d>(1));
    const Move_result result = walker.move_all(moved, box);
    CHECK((result.moves.asked == n && result.changed.empty()));
    CHECK(edges_of(walker) == edges);
}

template <int d>
std::vector<Coordinates<d>> random_points(std::size_t n, std::uint64_t seed) {
    Periodic_cases cases(seed);
    return cases.points<d>(cases.box<d>(0), n, 1);
}

/// The state as it can be seen.
template <int d>
auto state_of(const Periodic_mesh<d>& mesh) {
    const auto cells = mesh.cells();
    return std::tuple(std::vector<Coordinates<d>>(mesh.points().begin(), mesh.points().end()), mesh.box().vectors(),
                      cells.vertices, cells.offsets, cells.neighbours, cells.translations);
}

template <int d>
void expect_same_for_threads() {
    const auto x = random_points<d>(3000, 1);
    Coordinates<d> lengths;
    lengths.fill(1);
    const Box<d> box = Box<d>::orthorhombic(lengths);
    const Periodic_mesh<d> one(x, box), three(x, box, {.threads = 3});
    CHECK(edges_of(one) == edges_of(three));
    CHECK(state_of(one) == state_of(three));
}

template <class Call>
Error error_of(Call call) {
    try {
        call();
    } catch (const Error& e) {
        return e;
    }
    FAIL("no error");
    return {Error_code::usage, ""};
}

}  // namespace

TEST_CASE("Images, basis, numbers and history do not change a periodic triangulation", "[kernel][periodic]") {
    for (int k = 0; k < repeats(2); ++k)
        for (const int kind : {0, 1, 2, 4, 5, 7})
            for (const std::size_t n : {1U, 2U, 5U, 30U}) {
                expect_one_triangulation<2>(static_cast<std::uint64_t>(k), kind, n);
                expect_one_triangulation<3>(static_cast<std::uint64_t>(k), kind, n);
            }
}

TEST_CASE("Threads do not change a periodic triangulation", "[kernel][periodic]") {
    expect_same_for_threads<2>();
    expect_same_for_threads<3>();
}

TEST_CASE("A walk through wraps and changes of the box is right at every step", "[kernel][periodic]") {
    Periodic_cases cases(5);
    auto vectors = cases.box<3>(4).vectors();
    auto x = cases.points<3>(Box<3>(vectors), 40, 1);
    Periodic_mesh<3> mesh(x, Box<3>(vectors));
    for (int step = 0; step < repeats(20); ++step) {
        for (auto& p : x)
            for (double& c : p) c += cases.uniform(-0.3, 0.35);
        for (auto& v : vectors)
            for (double& c : v) c += cases.uniform(-0.02, 0.02);
        mesh.move_all(x, Box<3>(vectors));
        const Audit_result audit = mesh.audit();
        CHECK(audit.first_fault.empty());
        CHECK(audit.delaunay());
        const auto volumes = mesh.voronoi_volumes();
        CHECK(std::accumulate(volumes.begin(), volumes.end(), 0.0) == Approx(mesh.box().volume()).epsilon(1e-9));
        for (std::size_t i = 0; i < x.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c) CHECK(std::fabs(mesh.points()[i][c] - x[i][c]) < 1e-12);
    }
}

TEST_CASE("What is given back is taken as it is", "[kernel][periodic]") {
    Periodic_cases cases(6);
    for (int kind = 0; kind < Periodic_cases::kinds; ++kind) {
        CAPTURE(kind);
        const Box<3> box = cases.box<3>(kind);
        Periodic_mesh<3> mesh(cases.points<3>(box, 20, 2), box);
        const auto before = state_of(mesh);
        const std::vector<Coordinates<3>> points(mesh.points().begin(), mesh.points().end());
        mesh.move_all(points, Box<3>(mesh.box().vectors()));
        CHECK(state_of(mesh) == before);
    }
}

TEST_CASE("A saved mesh is the same, bit for bit, and wrong ones are refused", "[kernel][periodic]") {
    Periodic_cases cases(7);
    for (int kind = 0; kind < Periodic_cases::kinds; ++kind)
        for (const double far : {2.0, 1e6}) {
            CAPTURE(kind, far);
            const Box<3> box = cases.box<3>(kind);
            const Periodic_mesh<3> mesh(cases.points<3>(box, 20, far), box);
            const Periodic_mesh<3> again(mesh.saved());
            CHECK(state_of(again) == state_of(mesh));
            CHECK(std::equal(mesh.places().begin(), mesh.places().end(), again.places().begin(), again.places().end()));
            CHECK(std::equal(mesh.images().begin(), mesh.images().end(), again.images().begin(), again.images().end()));
            CHECK(again.saved().vectors == box.vectors());
        }
    // Rounded to doubles, these points are images of each other.
    const Box<2> box = Box<2>::orthorhombic({.3, .3});
    const Periodic_mesh<2> mesh(
        std::vector<Coordinates<2>>{{0.09999999999811848, 0.04999999999999982}, {30000.1, 0.05}}, box);
    CHECK(state_of(Periodic_mesh<2>(mesh.saved())) == state_of(mesh));
    const auto expect_refused = [&](auto change) {
        Saved_periodic_mesh<2> saved = mesh.saved();
        change(saved);
        CHECK(error_of([&] { (void)Periodic_mesh<2>(saved); }).code() == Error_code::bad_input);
    };
    expect_refused([](auto& s) { s.images.pop_back(); });
    expect_refused([](auto& s) { s.images[1][0] = 1 << 30; });
    expect_refused([](auto& s) { s.places[1][0] += 0.6; });
    expect_refused([](auto& s) { s.places[1][0] += 0x1p-54; });
    expect_refused([](auto& s) { s.places[1][0] = std::numeric_limits<double>::quiet_NaN(); });
}

TEST_CASE("A call that fails leaves a periodic mesh as it was, and names vertices", "[kernel][periodic]") {
    const Box<2> box = Box<2>::orthorhombic({1, 1});
    const auto x = random_points<2>(20, 9);
    Periodic_mesh<2> mesh(x, box, {.strategy = Periodic_strategy::signs});  // tolerances cope without memory
    const auto before = state_of(mesh);
    auto y = x;
    y[7] = {y[3][0] + 2, y[3][1] - 5};  // an image of another one
    Error e = error_of([&] { mesh.move_all(y); });
    CHECK(e.code() == Error_code::duplicate_point);
    REQUIRE(e.vertices().size() == 2);
    CHECK((e.vertices()[0] == 3 && e.vertices()[1] == 7));
    CHECK(std::string(e.what()) == "points 3 and 7 have, up to vectors of the box, the same position");
    CHECK(state_of(mesh) == before);
    y = x;
    y[4][1] = std::numeric_limits<double>::quiet_NaN();
    e = error_of([&] { mesh.move_all(y); });
    CHECK(e.code() == Error_code::not_finite);
    CHECK((e.vertices().size() == 1 && e.vertices()[0] == 4));
    y.pop_back();
    CHECK(error_of([&] { mesh.move_all(y); }).code() == Error_code::wrong_size);
    CHECK(error_of([&] { Periodic_mesh<2>(x, box, {.threads = 0}); }).code() == Error_code::usage);
    CHECK(state_of(mesh) == before);
    // The grid makes points one that are nearer than half of its spacing.
    y = x;
    y[11] = {y[2][0] + 0x1p-60, y[2][1]};
    CHECK(error_of([&] { mesh.move_all(y); }).code() == Error_code::duplicate_point);
    for (std::uint64_t n = 0;; n += 3) {
        auto z = x;
        for (auto& p : z) p[0] += 0.125;
        const Starved outcome = starve(n, Memory::short_for_good, [&] { mesh.move_all(z); });
        if (outcome == Starved::done) break;
        CHECK(outcome == Starved::refused);
        CHECK(state_of(mesh) == before);
    }
    CHECK(state_of(mesh) != before);
    CHECK(mesh.audit().delaunay());
}

TEST_CASE("A periodic move that flips and runs out of memory changes nothing", "[periodic]") {
    Periodic_cases cases(5);
    const Box<2> box = cases.box<2>(4);
    const auto x = cases.points<2>(box, 60, 1);
    auto y = x;
    for (auto& p : y)
        for (double& c : p) c += cases.uniform(-0.02, 0.02);
    Periodic_mesh<2> mesh(x, box, {.strategy = Periodic_strategy::signs});  // tolerances cope without memory
    const auto before = state_of(mesh);
    Move_result result;
    for (std::uint64_t n = 0;; ++n) {
        const Starved outcome = starve(n, Memory::short_for_good, [&] { result = mesh.move_all(y, box); });
        if (outcome == Starved::done) break;
        CHECK(outcome == Starved::refused);
        REQUIRE(state_of(mesh) == before);
    }
    CHECK(result.statistics.flips > 0);
    CHECK(mesh.audit().delaunay());
}

TEST_CASE("Points far from a box that is rounded are at the same places when they are given again", "[periodic]") {
    Periodic_cases cases(6);
    const Box<3> box = Box<3>::orthorhombic({3.615, 3.3, 2.7});
    auto x = cases.points<3>(box, 10, 1);
    for (auto& p : x)
        for (std::size_t i = 0; i < 3; ++i) p[i] += 1000 * box.vectors()[i][i];
    Periodic_mesh<3> mesh(x, box);
    const std::vector<Coordinates<3>> before(mesh.places().begin(), mesh.places().end());
    for (int turn = 0; turn < 2; ++turn) CHECK(mesh.move_all(x).moves.kept_in_place == x.size());
    CHECK(std::equal(before.begin(), before.end(), mesh.places().begin()));
    CHECK(mesh.saved().vectors == box.vectors());
}
