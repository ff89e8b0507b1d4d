// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic_mesh::changes: the pairs made and broken, by neighbour lists before and after, whatever images and bases.
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

template <int d>
void expect_changes(const Periodic_mesh<d>& mesh, const Pairs<d>& before, int sign,
                    const std::vector<Shift<d>>& turns) {
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

/// Steps of a box that is deformed, and at every third step given in another basis, with points given as any images.
template <int d>
void expect_right_changes(int kind, std::size_t n, std::uint64_t seed) {
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
        const Pairs<d> before = pairs_of(mesh);
        const int sign = step % 3 != 2 ? 0 : step % 2 == 0 ? 1 : -1;
        const double reach = step == 0 ? 0 : step % 4 == 3 ? 0.2 : 0.01;
        for (auto& v : vectors)
            for (double& c : v)
                if (step > 0) c *= 1 + cases.uniform(-0.02, 0.02);
        for (std::size_t i = 0; i < d; ++i) vectors[1][i] -= sign * vectors[0][i];
        std::vector<Shift<d>> turns(n);
        for (std::size_t v = 0; v < n; ++v) {
            f[v][0] += sign * f[v][1];
            for (std::size_t i = 0; i < d; ++i) {
                turns[v][i] = static_cast<std::int32_t>(cases.below(5)) - 2;
                f[v][i] += turns[v][i] + cases.uniform(-reach, reach);
            }
        }
        put();
        mesh.move_all(x, Box<d>(vectors));
        expect_changes(mesh, before, sign, turns);
        if (step == 0) CHECK((mesh.changes().made.first.empty() && mesh.changes().broken.first.empty()));
    }
    const std::vector<Shift<d>> still(n + 5);
    for (int step = 0; step < 4; ++step) {
        Pairs<d> before = pairs_of(mesh);
        const auto indices = mesh.insert(cases.points<d>(mesh.box(), static_cast<std::size_t>(step + 1)));
        expect_changes(mesh, before, 0, still);
        before = pairs_of(mesh);
        mesh.remove(std::span(indices).first(1));
        expect_changes(mesh, before, 0, still);
        before = pairs_of(mesh);
        mesh.remove(std::span(indices).subspan(1));
        expect_changes(mesh, before, 0, still);
    }
}

}  // namespace

TEST_CASE("The pairs that a call makes and breaks in a box, whatever images and bases are given", "[periodic]") {
    for (const int kind : {0, 1, 4, 5, 7, 9})
        for (int k = 0; k < repeats(1); ++k)
            for (const std::size_t n : {1U, 3U, 40U}) {
                expect_right_changes<2>(kind, n, static_cast<std::uint64_t>(k));
                expect_right_changes<3>(kind, n, static_cast<std::uint64_t>(k));
            }
}

TEST_CASE("A box of another lattice breaks every pair and makes every one", "[periodic]") {
    Periodic_cases cases(2);
    const auto x = cases.points<2>(cases.box<2>(0), 20);
    Periodic_mesh<2> mesh(x, Box<2>::orthorhombic({1, 1}), {.report_changes = true});
    const auto before = pairs_of(mesh);
    mesh.move_all(x, Box<2>::orthorhombic({3, 1}));
    CHECK(set_of<2>(mesh.changes().broken) == before);
    CHECK(set_of<2>(mesh.changes().made) == pairs_of(mesh));
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
