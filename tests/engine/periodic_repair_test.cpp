// SPDX-License-Identifier: GPL-3.0-or-later
// Moves of periodic meshes by flips: the same cells as a fresh build, after every step; when nothing is rebuilt.
#include <annulus/error.h>
#include <annulus/mesh/replace_periodic_cells.h>
#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/cells_of_periodic.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
void expect_as_built(const Periodic_mesh<d>& mesh, std::span<const Coordinates<d>> x, const Box<d>& box) {
    const Periodic_mesh<d> fresh(x, box);
    CHECK(cells_of(mesh) == cells_of(fresh));
    CHECK(mesh.neighbour_counts() == fresh.neighbour_counts());
    const Audit_result audit = mesh.audit();
    CHECK(audit.first_fault.empty());
    CHECK(audit.delaunay());
}

template <std::size_t d>
void strain(std::array<double, d>& p, const std::array<std::array<double, d>, d>& by) {
    const auto old = p;
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t j = 0; j < d; ++j) p[i] += by[i][j] * old[j];
}

/// Points and box that are strained together, and points that jitter, wrap, and are given as other images.
template <int d>
struct Walk {
    Walk(int kind, std::size_t n)
        : cases(n * 100 + static_cast<std::size_t>(kind)), vectors(cases.box<d>(kind).vectors()) {
        x = cases.points<d>(Box<d>(vectors), n, 1);
    }
    void step(double spacings, double strained, bool other_basis) {
        std::array<std::array<double, static_cast<std::size_t>(d)>, static_cast<std::size_t>(d)> by;
        for (auto& row : by)
            for (double& c : row) c = cases.uniform(-strained, strained);
        for (auto& v : vectors) strain(v, by);
        const double most = spacings * std::pow(Box<d>(vectors).volume() / static_cast<double>(x.size()), 1.0 / d);
        for (auto& p : x) {
            strain(p, by);
            for (double& c : p) c += cases.uniform(-most, most);
        }
        if (!other_basis) return;
        const double times = cases.uniform(-1, 1) < 0 ? -1 : 1;
        for (std::size_t i = 0; i < d; ++i) vectors[1][i] += times * vectors[0][i];
        for (auto& p : x)
            for (std::size_t i = 0; i < d; ++i) p[i] += static_cast<double>(cases.below(3)) * vectors[0][i];
    }
    Periodic_cases cases;
    typename Box<d>::Vectors vectors;
    std::vector<Coordinates<d>> x;
};

struct Steps {
    int all = 0, kept = 0, rebuilt = 0;
    std::uint64_t flips = 0;
};

template <int d>
Steps expect_same_as_built(int kind, std::size_t n, double spacings, double strained, int steps) {
    CAPTURE(d, kind, n, spacings, strained);
    Walk<d> walk(kind, n);
    Periodic_mesh<d> mesh(walk.x, Box<d>(walk.vectors));
    Steps done;
    for (int k = 0; k < steps; ++k) {
        walk.step(spacings, strained, k % 3 == 2 && kind < 4);
        const Box<d> box(walk.vectors);
        const Move_result result = mesh.move_all(walk.x, box);
        const Move_counts& m = result.moves;
        CHECK(m.asked == n);
        CHECK(m.within_tolerance + m.kept_in_place + m.flipped + m.rebuilt == n);
        CHECK((m.rebuilt == 0 || m.rebuilt == n));
        CHECK((result.statistics.flips == 0) == (m.flipped == 0));
        ++done.all;
        done.kept += m.within_tolerance + m.kept_in_place == n;
        done.rebuilt += m.rebuilt == n;
        done.flips += result.statistics.flips;
        expect_as_built<d>(mesh, walk.x, box);
    }
    return done;
}

template <int d>
Steps walk_all(double spacings, double strained) {
    Steps sum;
    for (int kind = 0; kind < Periodic_cases::kinds; ++kind)
        for (const std::size_t n : {1U, 2U, 3U, 5U, 8U, 12U, 60U}) {
            const Steps s = expect_same_as_built<d>(kind, n, spacings, strained, repeats(d == 2 ? 5 : n > 12 ? 1 : 3));
            sum.all += s.all, sum.kept += s.kept, sum.rebuilt += s.rebuilt, sum.flips += s.flips;
        }
    return sum;
}

/// Atoms on the sites of a crystal in 2^-6 of the box, or in 2D on a square lattice, moved by this from the corner.
template <int d>
std::vector<Coordinates<d>> crystal(double from_corner) {
    std::vector<Coordinates<d>> x;
    constexpr int side = 4;
    for (int k = 0; k < (d == 2 ? side * side : side * side * side); ++k) {
        Coordinates<d> p;
        for (std::size_t i = 0, left = static_cast<std::size_t>(k); i < d; ++i, left /= side)
            p[i] = from_corner + static_cast<double>(left % side) / side;
        x.push_back(p);
        for (double& c : p) c += 0.5 / side;
        if (d == 3) x.push_back(p);
    }
    return x;
}

template <int d>
void expect_crystal_as_built(double vibration, double from_corner) {
    CAPTURE(d, vibration, from_corner);
    Periodic_cases cases(1);
    Coordinates<d> lengths;
    lengths.fill(1);
    const Box<d> box = Box<d>::orthorhombic(lengths);
    const auto rest = crystal<d>(from_corner);
    Periodic_mesh<d> mesh(rest, box);
    for (int k = 0; k < 3; ++k) {
        auto x = rest;
        for (auto& p : x)
            for (double& c : p) c += cases.uniform(-vibration, vibration);
        mesh.move_all(x);
        expect_as_built<d>(mesh, x, box);
        mesh.move_all(rest);
        expect_as_built<d>(mesh, rest, box);
        x = rest;
        for (auto& p : x) p[0] += 0x1p-20 * (k + 1);  // it drifts
        mesh.move_all(x);
        expect_as_built<d>(mesh, x, box);
    }
}

}  // namespace

TEST_CASE("Periodic moves by flips give the cells of a fresh build, and small ones never rebuild",
          "[engine][periodic]") {
    for (const auto& [spacings, strained] : {std::pair(0.003, 0.0), std::pair(0.03, 0.02)}) {
        const Steps plane = walk_all<2>(spacings, strained), space = walk_all<3>(spacings, strained);
        CHECK(plane.rebuilt == 0);
        CHECK(space.rebuilt == 0);
        CHECK(plane.flips + space.flips > 10);
        CHECK((plane.kept > 10 && space.kept > 10));
    }
}

TEST_CASE("Violent periodic moves give the cells of a fresh build", "[engine][periodic]") {
    const Steps plane = walk_all<2>(0.3, 0.1), space = walk_all<3>(0.3, 0.1);
    // Builds of few points are cheap.
    CHECK(plane.rebuilt < plane.all / 4);
    CHECK(space.rebuilt < space.all / 4);
}

TEST_CASE("Twenty small steps of 300 points in a cube rebuild nothing", "[engine][periodic]") {
    const Steps steps = expect_same_as_built<3>(0, 300, 0.01, 0, 20);
    CHECK(steps.rebuilt == 0);
    CHECK(steps.flips > 200);
}

TEST_CASE("Crystals that vibrate, return and drift have the cells of a fresh build", "[engine][periodic]") {
    for (const double vibration : {0.0, 1e-12, 1e-6, 0.01}) {
        for (const double from_corner : {0.0, 0.0625}) {  // 0: atoms wrap when they vibrate
            expect_crystal_as_built<2>(vibration, from_corner);
            expect_crystal_as_built<3>(vibration, from_corner);
        }
    }
}

TEST_CASE("A periodic mesh that is at rest keeps its cells and their numbers", "[engine][periodic]") {
    Walk<3> walk(4, 40);
    const Box<3> box(walk.vectors);
    Periodic_mesh<3> mesh(walk.x, box);
    walk.step(0.05, 0.01, false);
    mesh.move_all(walk.x, Box<3>(walk.vectors));
    const auto before = mesh.cells();
    const Move_result result = mesh.move_all(walk.x, Box<3>(walk.vectors));
    CHECK(result.moves.kept_in_place == 40);
    CHECK(mesh.cells().vertices == before.vertices);
    CHECK(mesh.cells().neighbours == before.neighbours);
}

TEST_CASE("Points that are moved across the border together keep their cells, also after flips have given up",
          "[engine][periodic]") {
    Walk<3> walk(0, 400);
    const Box<3> box(walk.vectors);
    Periodic_mesh<3> mesh(walk.x, box);
    int given_up = 0;
    for (int k = 0; k < 4; ++k) {
        walk.step(k == 3 ? 3 : 0.3, 0, false);
        const Move_result result = mesh.move_all(walk.x, box);
        given_up += result.moves.rebuilt > 0 ? 1 : 0;
        for (auto& p : walk.x)
            for (double& c : p) c += 0.375;
        {
            const Move_counts moves = mesh.move_all(walk.x, box).moves;
            CHECK(moves.within_tolerance + moves.kept_in_place >= 390);
        }
        expect_as_built<3>(mesh, walk.x, box);
    }
    CHECK(given_up > 0);
}

TEST_CASE("A flip does not put two points at one place, and a refused move changes nothing", "[engine][periodic]") {
    const std::vector<Coordinates<2>> x{{0.01, 0.5}, {0.99, 0.5}, {0.5, 0.25}, {0.5, 0.75}};
    const Box<2> box = Box<2>::orthorhombic({1, 1});
    Periodic_mesh<2> mesh(x, box);
    const auto before = mesh.cells();
    const std::vector<Coordinates<2>> places(mesh.places().begin(), mesh.places().end());
    auto y = x;
    y[0][0] = y[1][0] = 0;  // they meet across the border
    y[2][1] = 0.5, y[2][0] = 0.25;
    Error_code code{};
    try {
        mesh.move_all(y);
    } catch (const Error& e) {
        code = e.code();
    }
    CHECK(code == Error_code::duplicate_point);
    CHECK(mesh.cells().vertices == before.vertices);
    CHECK(mesh.cells().offsets == before.offsets);
    CHECK(std::equal(places.begin(), places.end(), mesh.places().begin(), mesh.places().end()));
    expect_as_built<2>(mesh, x, box);
}

TEST_CASE("Periodic cells are replaced by cells with the same border only", "[mesh][periodic]") {
    // One point in a square: two triangles, whose union is glued to itself all around.
    const auto table = [] {
        Periodic_table<2> t;
        const auto o = [](int i, int j) { return Offset<2>({i, j}); };
        t.vertex = {{0, 0, 0}, {0, 0, 0}};
        t.offset = {{o(0, 0), o(1, 0), o(1, 1)}, {o(0, 0), o(1, 1), o(0, 1)}};
        t.twin = {{t.corner(1, 1), t.corner(1, 2), t.corner(1, 0)}, {t.corner(0, 2), t.corner(0, 0), t.corner(0, 1)}};
        return t;
    };
    Periodic_table<2> t = table();
    const auto image = [](int i, int j) { return Image<2>(0, Offset<2>({i, j})); };
    const std::array gone{Lifted_cell<2>{0, {}}, Lifted_cell<2>{1, {}}};
    std::vector<std::size_t> unused, made;
    const std::array<Cell_images<2>, 2> other{
        {{image(0, 0), image(1, 0), image(0, 1)}, {image(1, 0), image(1, 1), image(0, 1)}}};
    CHECK(replace_periodic_cells<2>(t, gone, other, unused, made));
    CHECK(made == std::vector<std::size_t>{0, 1});
    for (std::size_t c = 0; c < 2; ++c)
        for (std::size_t i = 0; i < 3; ++i) {
            const Corner_index h = t.twin[c][i];
            CHECK(t.cell_of(h) == 1 - c);
            CHECK(t.twin[t.cell_of(h)][t.slot_of(h)] == t.corner(c, i));
        }
    t = table();
    const std::array<Cell_images<2>, 2> longer{
        {{image(0, 0), image(1, 0), image(2, 1)}, {image(0, 0), image(2, 1), image(0, 1)}}};
    CHECK(!replace_periodic_cells<2>(t, gone, longer, unused, made));
    CHECK(!replace_periodic_cells<2>(t, std::array{gone[0], gone[0]}, other, unused, made));
    CHECK(t.offset == table().offset);
    CHECK(t.twin == table().twin);
}
