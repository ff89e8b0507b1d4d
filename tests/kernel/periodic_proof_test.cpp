// SPDX-License-Identifier: GPL-3.0-or-later
// What is_proved_delaunay accepts: the tables that Periodic_builder makes, and no other.
#include <annulus/error.h>
#include <annulus/kernel/periodic_builder.h>
#include <annulus/kernel/periodic_proof.h>

#include <support/catch.h>
#include <support/periodic_boxes.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
struct Built {
    Built(const Box<d>& box, const std::vector<Coordinates<d>>& x) : lattice(box.vectors()) {
        for (const auto& p : x) place.push_back(lattice.representative(p, 0).place);
        Periodic_builder<d>().build(lattice, place, 1, table);
    }
    [[nodiscard]] bool is_proved(Periodic_table<d> t) const { return is_proved_delaunay<d>(t, lattice, place); }
    /// After changes of everything or of a cell and its neighbours.
    [[nodiscard]] bool is_still_proved(Periodic_table<d> t) const {
        Periodic_journal<d> journal;
        journal.begin(table);
        for (std::size_t c = 0; c < table.size(); ++c) journal.keep(table, c);
        return is_still_proved(std::move(t), journal);
    }
    [[nodiscard]] bool is_still_proved(Periodic_table<d> t, std::size_t changed) const {
        Periodic_journal<d> journal;
        journal.begin(table);
        journal.keep_around(table, changed);
        return is_still_proved(std::move(t), journal);
    }
    [[nodiscard]] bool is_still_proved(Periodic_table<d> t, const Periodic_journal<d>& journal,
                                       std::span<const std::size_t> unfinished = {}) const {
        t.cospherical.resize(t.size());
        return is_still_proved_delaunay<d>(t, lattice, place, {journal, place, unfinished});
    }

    Lattice<d> lattice;
    std::vector<Coordinates<d>> place;
    Periodic_table<d> table;
};

template <int d>
void expect_only_right_ones_pass(std::size_t n, int kind) {
    CAPTURE(d, n, kind);
    Periodic_cases cases(n);
    const Box<d> box = cases.box<d>(kind);
    Built<d> built(box, cases.points<d>(box, n));
    CHECK(built.is_proved(built.table));
    CHECK(built.is_still_proved(built.table));
    Shift<d> unit{};
    unit[0] = 1;
    const auto refused = [&](const Periodic_table<d>& wrong, std::size_t c) {
        return !built.is_proved(wrong) && !built.is_still_proved(wrong) && !built.is_still_proved(wrong, c);
    };
    for (std::size_t c = 0; c < built.table.size(); c += 1 + built.table.size() / 7) {
        auto wrong = built.table;
        wrong.offset[c][1] = wrong.offset[c][1] + Offset<d>(unit);
        CHECK(refused(wrong, c));
        wrong = built.table;  // inverted, and glued as before
        std::swap(wrong.vertex[c][0], wrong.vertex[c][1]);
        std::swap(wrong.offset[c][0], wrong.offset[c][1]);
        std::swap(wrong.twin[c][0], wrong.twin[c][1]);
        for (std::size_t i = 0; i < 2; ++i) {
            const Corner_index t = wrong.twin[c][i];
            wrong.twin[wrong.cell_of(t)][wrong.slot_of(t)] = wrong.corner(c, i);
        }
        CHECK(refused(wrong, c));
        wrong = built.table;
        std::swap(wrong.twin[c][0], wrong.twin[c][1]);
        CHECK(refused(wrong, c));
        wrong = built.table;
        wrong.twin[c][0] = no_corner;
        CHECK(refused(wrong, c));
        wrong = built.table;  // a neighbour is glued to nothing
        const Corner_index t = wrong.twin[c][0];
        wrong.twin[wrong.cell_of(t)][wrong.slot_of(t)] = no_corner;
        CHECK(refused(wrong, c));
    }
    built.place.push_back(built.place[0]);  // a vertex in no cell
    CHECK(!built.is_proved(built.table));
}

/// One point and two triangles.
Periodic_table<2> two_triangles(const std::array<std::array<Shift<2>, 3>, 2>& offsets,
                                const std::array<std::size_t, 3>& partner) {
    Periodic_table<2> table;
    for (const auto& cell : offsets) {
        table.vertex.push_back({0, 0, 0});
        table.offset.push_back({Offset<2>(cell[0]), Offset<2>(cell[1]), Offset<2>(cell[2])});
        table.twin.push_back({no_corner, no_corner, no_corner});
    }
    for (std::size_t i = 0; i < 3; ++i) {
        table.twin[0][i] = table.corner(1, partner[i]);
        table.twin[1][partner[i]] = table.corner(0, i);
    }
    return table;
}

}  // namespace

TEST_CASE("Built periodic tables are proved, and damaged ones are not", "[kernel][periodic]") {
    for (const std::size_t n : {1U, 2U, 5U, 40U})
        for (const int kind : {0, 2, 4}) {
            expect_only_right_ones_pass<2>(n, kind);
            expect_only_right_ones_pass<3>(n, kind);
        }
}

TEST_CASE("Positive, glued, locally Delaunay cells that cover the torus twice are not proved", "[kernel][periodic]") {
    const Built<2> built(Box<2>({{{1, 0}, {0.3125, 1}}}), {{0, 0}});
    // The edges 0 1, 1 2 and 2 0 of the first are (2, 0), (-2, 1) and (0, -1).
    const auto twice = two_triangles({{{{{0, 0}, {2, 0}, {0, 1}}}, {{{2, 0}, {2, 1}, {0, 1}}}}}, {1, 2, 0});
    CHECK(!built.is_proved(twice));
    CHECK(!built.is_still_proved(twice));
    const auto once = two_triangles({{{{{0, 0}, {1, 0}, {0, 1}}}, {{{1, 0}, {1, 1}, {0, 1}}}}}, {1, 2, 0});
    CHECK(built.is_proved(once));
    CHECK(built.is_still_proved(once));
}

TEST_CASE("A changed table is not proved where a cell is gone that others are glued to", "[kernel][periodic]") {
    Periodic_cases cases(7);
    const Box<2> box = cases.box<2>(4);
    const Built<2> built(box, cases.points<2>(box, 40));
    Periodic_table<2> table = built.table;
    const std::size_t last = table.size() - 1;
    Periodic_journal<2> journal;
    journal.begin(table);
    journal.keep_around(table, last);
    // Cells that are not beside it, and have its corners, are moved by a vector of the box.
    std::vector<std::size_t> near{last};
    for (const Corner_index t : table.twin[last]) near.push_back(table.cell_of(t));
    std::vector<std::size_t> far;
    for (const Index v : table.vertex[last])
        for (std::size_t c = 0; c < last; ++c) {
            const auto& corners = table.vertex[c];
            if (std::find(corners.begin(), corners.end(), v) == corners.end()) continue;
            if (std::find(near.begin(), near.end(), c) == near.end()) far.push_back(c);
        }
    std::sort(far.begin(), far.end());
    far.erase(std::unique(far.begin(), far.end()), far.end());
    for (const std::size_t c : far) {
        journal.keep(table, c);
        for (Offset<2>& o : table.offset[c]) o = o + Offset<2>({1, 0});
    }
    CHECK(built.is_still_proved(table, journal));
    table.vertex.pop_back();
    table.offset.pop_back();
    table.twin.pop_back();
    CHECK(!built.is_still_proved(table, journal));
}

TEST_CASE("A changed table is not proved where a vertex has lost its cells, or an unfinished facet is violated",
          "[kernel][periodic]") {
    const Box<2> square = Box<2>::orthorhombic({1, 1});
    const Built<2> two(square, {{0, 0}, {0.5, 0.25}}), one(square, {{0, 0}});
    CHECK(two.table.size() == 4);
    CHECK(!two.is_still_proved(one.table));
    Periodic_cases cases(6);
    Built<2> built(square, cases.points<2>(square, 30));
    Periodic_journal<2> nothing;
    nothing.begin(built.table);
    for (auto& p : built.place) p = built.lattice.representative({0.9 * p[0] + 0.08 * p[1] * p[1], p[1]}, 0).place;
    std::vector<std::size_t> all(built.table.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    CHECK(!built.is_proved(built.table));
    CHECK(!built.is_still_proved(built.table, nothing, all));
}

TEST_CASE("A table is not proved where a vertex has moved through a facet, and two cells on one side are none",
          "[kernel][periodic]") {
    Periodic_cases cases(4);
    const Box<2> box = cases.box<2>(0);
    Built<2> built(box, cases.points<2>(box, 12));
    for (std::size_t v = 0; v < 12; ++v) {
        CAPTURE(v);
        const Coordinates<2> before = std::exchange(built.place[v], built.lattice.representative({0.5, 0.25}, 0).place);
        CHECK(!built.is_proved(built.table));
        built.place[v] = before;
    }
    // One vertex moves through the opposite edge of the last cell alone: only that cell is inverted.
    const std::size_t last = built.table.size() - 1;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto at = [&](std::size_t k) {
            const Image<2> s = built.table.image(last, k);
            return built.lattice.place(built.place[static_cast<std::size_t>(s.vertex)], s.label);
        };
        const Coordinates<2> a = at((i + 1) % 3), b = at((i + 2) % 3), p = at(i);
        const auto v = static_cast<std::size_t>(built.table.vertex[last][i]);
        const Coordinates<2> before = built.place[v];
        for (std::size_t k = 0; k < 2; ++k) built.place[v][k] += 1.001 * ((a[k] + b[k]) / 2 - p[k]);
        CHECK(!built.is_proved(built.table));
        built.place[v] = before;
    }
    // A triangle twice, glued to itself: half of the torus, counted twice.
    const Built<2> one(Box<2>({{{1, 0}, {0.25, 1}}}), {{0, 0}});
    const auto twice = two_triangles({{{{{0, 0}, {1, 0}, {0, 1}}}, {{{0, 0}, {1, 0}, {0, 1}}}}}, {0, 1, 2});
    CHECK(!one.is_proved(twice));
}

TEST_CASE("Of the diagonals of a square the perturbation proves one, and a diagonal that is too long none",
          "[kernel][periodic]") {
    const auto falling = two_triangles({{{{{0, 0}, {1, 0}, {0, 1}}}, {{{1, 0}, {1, 1}, {0, 1}}}}}, {1, 2, 0});
    const auto rising = two_triangles({{{{{0, 0}, {1, 0}, {1, 1}}}, {{{0, 0}, {1, 1}, {0, 1}}}}}, {1, 2, 0});
    const Built<2> square(Box<2>::orthorhombic({1, 1}), {{0, 0}});
    CHECK(square.is_proved(falling) != square.is_proved(rising));
    const Built<2> left(Box<2>({{{1, 0}, {-0.25, 1}}}), {{0, 0}});
    CHECK(left.is_proved(rising));
    CHECK(!left.is_proved(falling));
}

TEST_CASE("Needles across the axes are proved, too, down to where doubles have no coordinates in them",
          "[kernel][periodic]") {
    const double c = std::cos(0.5), s = std::sin(0.5), thin = 0x1p-24;
    const Box<2> box({{{c, s}, {-s * thin, c * thin}}});
    Periodic_cases cases(1);
    const Built<2> built(box, cases.points<2>(box, 20));
    CHECK(built.table.size() == 40);
    CHECK(built.is_proved(built.table));
    CHECK_THROWS_AS(Box<2>({{{c, s}, {-s * 0x1p-44, c * 0x1p-44}}}), Error);
}

TEST_CASE("A collar that is too narrow is widened", "[kernel][periodic]") {
    // Half of the box is empty, so that spheres are much larger than the mean spacing.
    Periodic_cases cases(2);
    std::vector<Coordinates<3>> x;
    for (int k = 0; k < 4000; ++k) x.push_back({cases.uniform(0, 1), cases.uniform(0, 1), cases.uniform(0.3, 0.7)});
    const Lattice<3> lattice(Box<3>::orthorhombic({1, 1, 1}).vectors());
    for (auto& p : x) p = lattice.representative(p, 0).place;
    Periodic_builder<3> builder;
    Periodic_table<3> table;
    builder.build(lattice, x, 1, table);
    CHECK(builder.attempts() > 1);
    CHECK(is_proved_delaunay<3>(table, lattice, x));
}

TEST_CASE("In a box that is thinner than the spacing of points the collar is as wide as needed at once",
          "[kernel][periodic]") {
    Periodic_cases cases(3);
    for (const double length : {1e3, 1e6}) {
        const Box<3> box = Box<3>::orthorhombic({length, 1, 1});
        const Lattice<3> lattice(box.vectors());
        auto x = cases.points<3>(box, 200);
        for (auto& p : x) p = lattice.representative(p, 0).place;
        Periodic_builder<3> builder;
        Periodic_table<3> table;
        builder.build(lattice, x, 1, table);
        CHECK(builder.attempts() <= 3);
    }
}

TEST_CASE("A collar as wide as spheres suffices, also where circumcentres are on sides of the box",
          "[kernel][periodic]") {
    const auto build = [](const auto& box, auto x, auto& builder) {
        constexpr int d = std::tuple_size_v<typename std::decay_t<decltype(x)>::value_type>;
        const Lattice<d> lattice(box.vectors());
        for (auto& p : x) p = lattice.representative(p, 0).place;
        Periodic_table<d> table;
        builder.build(lattice, x, 1, table);
        CHECK(builder.attempts() == 1);
        return static_cast<double>(builder.copies()) / static_cast<double>(x.size());
    };
    Periodic_builder<2> in_2d;
    Periodic_builder<3> in_3d;
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        Periodic_cases cases(seed);
        const Box<2> square = cases.box<2>(0);
        CHECK(build(square, cases.points<2>(square, 2000), in_2d) < 1.2);
        const Box<3> tilted = cases.box<3>(4);
        CHECK(build(tilted, cases.points<3>(tilted, 4000), in_3d) < 2.2);
    }
    const Box<3> cube = Box<3>::orthorhombic({6, 6, 6});
    std::vector<Coordinates<3>> simple, faces;
    for (int i = 0; i < 216; ++i) {
        const double a = i % 6, b = i / 6 % 6, c = i / 36;
        simple.push_back({a, b, c});
        for (const auto& [p, q, r] : {Coordinates<3>{0, 0, 0}, {.5, .5, 0}, {.5, 0, .5}, {0, .5, .5}})
            faces.push_back({a + p, b + q, c + r});
    }
    build(cube, simple, in_3d);
    build(cube, faces, in_3d);
    for (auto& p : faces)  // centres of cells are on sides of the box
        for (double& c : p) c += 0.25;
    build(cube, faces, in_3d);
}
