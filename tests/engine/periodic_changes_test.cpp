// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic_mesh::changes: the pairs made and broken, by neighbour lists before and after, and the cells, whatever
// images and bases.
#include <annulus/error.h>
#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/failing_new.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
using Pair = std::tuple<Index, Index, Shift<d>>;
template <int d>
using Pairs = std::set<Pair<d>>;

template <int d>
Shift<d> negative(Shift<d> s) {
    for (auto& c : s) c = -c;
    return s;
}

/// The pairs of the neighbour list, each once.
template <int d>
Pairs<d> pairs_of(const Periodic_mesh<d>& mesh) {
    Pairs<d> pairs;
    const auto list = mesh.neighbours();
    for (std::size_t k = 0; k < list.first.size(); ++k) {
        const Index i = list.first[k], j = list.second[k];
        if (i < j || (i == j && negative<d>(list.shift[k]) < list.shift[k])) pairs.emplace(i, j, list.shift[k]);
    }
    return pairs;
}

template <int d>
Pairs<d> set_of(const Periodic_pairs<d>& list) {
    Pairs<d> pairs;
    REQUIRE((list.second.size() == list.first.size() && list.shift.size() == list.first.size()));
    for (std::size_t k = 0; k < list.first.size(); ++k) {
        if (k > 0)
            CHECK(std::tie(list.first[k - 1], list.second[k - 1], list.shift[k - 1]) <
                  std::tie(list.first[k], list.second[k], list.shift[k]));
        pairs.emplace(list.first[k], list.second[k], list.shift[k]);
    }
    return pairs;
}

/// A cell as a set of corners, which are at these offsets from one of them, and the sign of their order; of all ways to
/// say this the least.
template <int d>
using Cell = std::tuple<std::vector<std::pair<Index, Shift<d>>>, bool>;
template <int d>
using Cells = std::set<Cell<d>>;

template <int d, class Vertices, class Offsets>
Cell<d> cell_of(const Vertices& vertices, const Offsets& offsets) {
    Cell<d> least;
    for (std::size_t base = 0; base <= d; ++base) {
        Cell<d> cell;
        auto& [corners, is_odd] = cell;
        is_odd = false;
        for (std::size_t i = 0; i <= d; ++i) {
            Shift<d> s = offsets[i];
            for (std::size_t c = 0; c < d; ++c) s[c] -= offsets[base][c];
            corners.emplace_back(vertices[i], s);
        }
        for (std::size_t i = 0; i <= d; ++i)  // insertion sort
            for (std::size_t j = i; j > 0 && corners[j] < corners[j - 1]; --j) {
                std::swap(corners[j], corners[j - 1]);
                is_odd = !is_odd;
            }
        if (base == 0 || cell < least) least = cell;
    }
    return least;
}

template <int d, class List>
Cells<d> cells_in(const List& list) {
    Cells<d> cells;
    REQUIRE(list.vertices.size() == list.offsets.size());
    for (std::size_t c = 0; c < list.vertices.size(); ++c) {
        if constexpr (!requires { list.neighbours; })  // ascending, and the least offset is 0
            if (c > 0)
                CHECK(std::tie(list.vertices[c - 1], list.offsets[c - 1]) <
                      std::tie(list.vertices[c], list.offsets[c]));
        for (std::size_t k = 0; k < d; ++k) {
            std::int32_t lowest = list.offsets[c][0][k];
            for (const auto& o : list.offsets[c]) lowest = std::min(lowest, o[k]);
            CHECK(lowest == 0);
        }
        CHECK(cells.insert(cell_of<d>(list.vertices[c], list.offsets[c])).second);
    }
    return cells;
}

/// A pair in the basis that has b_1 - sign * b_0 for b_1, where point v is given as its image turns[v] of that.
template <int d>
Pair<d> renamed(Pair<d> pair, int sign, const std::vector<Shift<d>>& turns) {
    auto [i, j, s] = pair;
    s[0] += sign * s[1];
    for (std::size_t c = 0; c < d; ++c)
        s[c] += turns[static_cast<std::size_t>(i)][c] - turns[static_cast<std::size_t>(j)][c];
    if (i == j) s = std::max(s, negative<d>(s));
    return {i, j, s};
}

/// The same of a cell.
template <int d>
Cell<d> renamed(Cell<d> cell, int sign, const std::vector<Shift<d>>& turns) {
    auto& [corners, is_odd] = cell;
    std::vector<Index> vertices;
    std::vector<Shift<d>> offsets;
    for (auto [v, s] : corners) {
        s[0] += sign * s[1];
        for (std::size_t c = 0; c < d; ++c) s[c] -= turns[static_cast<std::size_t>(v)][c];
        vertices.push_back(v);
        offsets.push_back(s);
    }
    Cell<d> name = cell_of<d>(vertices, offsets);
    std::get<bool>(name) ^= is_odd;
    return name;
}

/// Pairs and cells, to be compared with those after a call.
template <int d>
struct Seen {
    Pairs<d> pairs;
    Cells<d> cells;
};
template <int d>
Seen<d> seen(const Periodic_mesh<d>& mesh) {
    return {pairs_of(mesh), cells_in<d>(mesh.cells())};
}

template <int d>
void expect_cell_changes(const Periodic_mesh<d>& mesh, const Cells<d>& before, int sign,
                         const std::vector<Shift<d>>& turns) {
    const Cells<d> after = cells_in<d>(mesh.cells());
    Cells<d> names, gone, changed;
    for (const Cell<d>& cell : before) {
        const Cell<d> name = renamed<d>(cell, sign, turns);
        names.insert(name);
        if (!after.contains(name)) gone.insert(cell);
    }
    for (const Cell<d>& cell : after)
        if (!names.contains(cell)) changed.insert(cell);
    CHECK(cells_in<d>(mesh.changes().changed) == changed);
    CHECK(cells_in<d>(mesh.changes().gone) == gone);
}

template <int d>
void expect_changes(const Periodic_mesh<d>& mesh, const Seen<d>& seen, int sign, const std::vector<Shift<d>>& turns) {
    expect_cell_changes(mesh, seen.cells, sign, turns);
    const Pairs<d>& before = seen.pairs;
    const Pairs<d> after = pairs_of(mesh);
    Pairs<d> names, broken, made;
    for (const Pair<d>& p : before) {
        const Pair<d> name = renamed<d>(p, sign, turns);
        names.insert(name);
        if (!after.contains(name)) broken.insert(p);
    }
    for (const Pair<d>& p : after)
        if (!names.contains(p)) made.insert(p);
    CHECK(set_of<d>(mesh.changes().made) == made);
    CHECK(set_of<d>(mesh.changes().broken) == broken);
}

/// The vector of the lattice, in these, that is nearest to where `f` vectors lead.
template <int d>
Shift<d> nearest(const typename Box<d>::Vectors& vectors, const Coordinates<d>& f) {
    constexpr std::int32_t most = 12;
    Shift<d> best{}, s;
    double least = -1;
    s.fill(-most);
    for (std::size_t i = 0; i < d;) {
        Coordinates<d> way{};
        for (std::size_t j = 0; j < d; ++j)
            for (std::size_t k = 0; k < d; ++k) way[k] += (f[j] - s[j]) * vectors[j][k];
        double squared = 0;
        for (const double c : way) squared += c * c;
        if (least < 0 || squared < least) least = squared, best = s;
        for (i = 0; i < d && ++s[i] > most; ++i) s[i] = -most;
    }
    return best;
}

/// Steps of a box that is deformed, and at every third step given in another basis, with points given as any images.
template <int d>
void expect_right_changes(int kind, std::size_t n, std::uint64_t seed, double far = 0.2) {
    CAPTURE(d, kind, n, seed);
    Periodic_cases cases(seed);
    auto vectors = cases.box<d>(kind).vectors();
    std::vector<Coordinates<d>> f(n), x(n);  // in the vectors, and positions
    const auto put = [&] {
        for (std::size_t v = 0; v < f.size(); ++v) {
            x[v] = {};
            for (std::size_t j = 0; j < d; ++j)
                for (std::size_t i = 0; i < d; ++i) x[v][i] += f[v][j] * vectors[j][i];
        }
    };
    for (auto& p : f)
        for (double& c : p) c = cases.uniform(-1, 1);
    put();
    Periodic_mesh<d> mesh(x, Box<d>(vectors), {.report_changes = true});
    CHECK((mesh.changes().made.first.empty() && mesh.changes().broken.first.empty()));
    for (int step = 0; step < 9; ++step) {
        CAPTURE(step);
        const Seen<d> before = seen(mesh);
        const int sign = step % 3 != 2 ? 0 : step % 2 == 0 ? 1 : -1;
        const double reach = step == 0 ? 0 : step % 4 == 3 ? far : 0.01;
        for (auto& v : vectors)
            for (double& c : v)
                if (step > 0) c *= 1 + cases.uniform(-0.02, 0.02);
        for (std::size_t i = 0; i < d; ++i) vectors[1][i] -= sign * vectors[0][i];
        std::vector<Shift<d>> turns(n);
        for (std::size_t v = 0; v < n; ++v) {
            f[v][0] += sign * f[v][1];
            Coordinates<d> way;
            for (double& c : way) c = cases.uniform(-reach, reach);
            const Shift<d> near = nearest<d>(vectors, way);
            for (std::size_t i = 0; i < d; ++i) {
                const std::int32_t turn = static_cast<std::int32_t>(cases.below(5)) - 2;
                f[v][i] += turn + way[i];
                turns[v][i] = turn + near[i];
            }
        }
        put();
        mesh.move_all(x, Box<d>(vectors));
        expect_changes(mesh, before, sign, turns);
        if (step == 0) {
            CHECK((mesh.changes().made.first.empty() && mesh.changes().broken.first.empty()));
            CHECK((mesh.changes().changed.vertices.empty() && mesh.changes().gone.vertices.empty()));
        }
    }
    const std::vector<Shift<d>> still(n + 5);
    for (int step = 0; step < 4; ++step) {
        Seen<d> before = seen(mesh);
        const auto indices = mesh.insert(cases.points<d>(mesh.box(), static_cast<std::size_t>(step + 1)));
        expect_changes(mesh, before, 0, still);
        before = seen(mesh);
        mesh.remove(std::span(indices).first(1));
        expect_changes(mesh, before, 0, still);
        before = seen(mesh);
        mesh.remove(std::span(indices).subspan(1));
        expect_changes(mesh, before, 0, still);
    }
}

}  // namespace

TEST_CASE("The pairs and cells that a call changes in a box, whatever images and bases are given", "[periodic]") {
    for (const int kind : {0, 1, 4, 5, 7, 9})
        for (int k = 0; k < repeats(1); ++k)
            for (const std::size_t n : {1U, 3U, 40U}) {
                expect_right_changes<2>(kind, n, static_cast<std::uint64_t>(k));
                expect_right_changes<3>(kind, n, static_cast<std::uint64_t>(k));
            }
}

TEST_CASE("A pair stays where a point moves to the nearest image, however skewed the vectors of the box are",
          "[periodic]") {
    const std::vector<Coordinates<2>> x{{.1, .1}, {.6, .45}, {.3, .75}};
    Periodic_mesh<2> mesh(x, Box<2>({{{1, 0}, {8, 1}}}), {.report_changes = true});
    mesh.move(0, {.1, .17});  // 0.07 of one vector, and 0.56 of the other
    CHECK((mesh.changes().made.first.empty() && mesh.changes().broken.first.empty()));
    CHECK((mesh.changes().changed.vertices.empty() && mesh.changes().gone.vertices.empty()));
    for (const int kind : {5, 8, 9})
        for (int k = 0; k < repeats(3); ++k) expect_right_changes<2>(kind, 4, 100 + static_cast<std::uint64_t>(k), 0.3);
    for (const int kind : {5, 8})
        for (int k = 0; k < repeats(3); ++k) expect_right_changes<3>(kind, 4, 100 + static_cast<std::uint64_t>(k), 0.3);
}

TEST_CASE("A box of another lattice breaks every pair and cell, and makes every one", "[periodic]") {
    Periodic_cases cases(2);
    const auto x = cases.points<2>(cases.box<2>(0), 20);
    Periodic_mesh<2> mesh(x, Box<2>::orthorhombic({1, 1}), {.report_changes = true});
    const Seen<2> before = seen(mesh);
    mesh.move_all(x, Box<2>::orthorhombic({3, 1}));
    CHECK(set_of<2>(mesh.changes().broken) == before.pairs);
    CHECK(set_of<2>(mesh.changes().made) == pairs_of(mesh));
    CHECK(cells_in<2>(mesh.changes().gone) == before.cells);
    CHECK(cells_in<2>(mesh.changes().changed) == cells_in<2>(mesh.cells()));
}

TEST_CASE("A cell that is turned over is gone and has come in a box, its edges neither", "[periodic]") {
    std::vector<Coordinates<2>> y{{0.1, 0.1}, {0.4, 0.1}, {0.2, 0.15}};
    Periodic_mesh<2> mesh(y, Box<2>::orthorhombic({1, 1}), {.report_changes = true});
    y[2][1] = 0.05;
    const Seen<2> before = seen(mesh);
    mesh.move_all(y);
    expect_changes(mesh, before, 0, std::vector<Shift<2>>(3));
    const auto is_of_all = [](const auto& v) { return v[0] != v[1] && v[1] != v[2] && v[0] != v[2]; };
    const auto& changed = mesh.changes().changed.vertices;
    CHECK(std::count_if(changed.begin(), changed.end(), is_of_all) > 0);
}

TEST_CASE("Changes are listed on request, are those of the last call that succeeded, and are all or nothing",
          "[periodic]") {
    Periodic_cases cases(3);
    const Box<2> box = cases.box<2>(4);
    const auto x = cases.points<2>(box, 30);
    auto y = x;
    for (auto& p : y) p[0] += cases.uniform(-0.03, 0.03);
    Periodic_mesh<2> silent(x, box);
    silent.move_all(y, box);
    CHECK((silent.changes().made.first.empty() && silent.changes().broken.first.empty()));
    Periodic_mesh<2> mesh(x, box, {.report_changes = true});
    const auto before = pairs_of(mesh);
    for (std::uint64_t n = 0;; ++n) {
        const Starved outcome = starve(n, Memory::short_for_good, [&] { mesh.move_all(y, box); });
        if (outcome == Starved::done) break;
        CHECK(outcome == Starved::refused);
        REQUIRE(pairs_of(mesh) == before);
        REQUIRE(mesh.changes().made.first.empty());
    }
    const auto made = set_of<2>(mesh.changes().made);
    CHECK(!made.empty());
    CHECK_THROWS_AS(mesh.insert(mesh.points()[3]), Error);
    CHECK(set_of<2>(mesh.changes().made) == made);
    mesh.move_all(y, box);
    CHECK(mesh.changes().made.first.empty());
}
