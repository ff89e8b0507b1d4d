// SPDX-License-Identifier: GPL-3.0-or-later
// The lists of what a call changed are the differences of what there was before and what there is after it.
#include <annulus/annulus.h>

#include <support/catch.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace {

using Pair = std::pair<std::int32_t, std::int32_t>;
using Lister = int (*)(const annulus_mesh*, size_t, std::int32_t*, size_t*);

std::vector<std::int32_t> numbers(const annulus_mesh* mesh, Lister list, std::size_t each) {
    std::size_t count = 0;
    REQUIRE(list(mesh, 0, nullptr, &count) == ANNULUS_OK);
    std::vector<std::int32_t> out(count * each);
    REQUIRE(list(mesh, count, out.data(), &count) == ANNULUS_OK);
    return out;
}

std::vector<Pair> listed(const annulus_mesh* mesh, Lister list) {
    const auto n = numbers(mesh, list, 2);
    std::vector<Pair> out;
    for (std::size_t k = 0; k < n.size(); k += 2) out.emplace_back(n[k], n[k + 1]);
    return out;
}

std::set<Pair> edges_now(const annulus_mesh* mesh) {
    std::size_t bound = 0, count = 0;
    REQUIRE(annulus_index_bound(mesh, &bound) == ANNULUS_OK);
    std::vector<std::int32_t> begin(bound + 1);
    REQUIRE(annulus_neighbour_lists(mesh, bound + 1, begin.data(), 0, nullptr, &count) == ANNULUS_OK);
    std::vector<std::int32_t> to(count);
    REQUIRE(annulus_neighbour_lists(mesh, bound + 1, begin.data(), count, to.data(), &count) == ANNULUS_OK);
    std::set<Pair> out;
    for (std::size_t v = 0; v < bound; ++v)
        for (auto k = static_cast<std::size_t>(begin[v]); k < static_cast<std::size_t>(begin[v + 1]); ++k)
            if (to[k] > static_cast<std::int32_t>(v)) out.emplace(static_cast<std::int32_t>(v), to[k]);
    return out;
}

/// The finite cells of a list that is written by `list`, corners sorted.
std::set<std::vector<std::int32_t>> finite_cells(const std::vector<std::int32_t>& list, std::size_t corners) {
    std::set<std::vector<std::int32_t>> out;
    for (auto c = list.begin(); c != list.end(); c += static_cast<std::ptrdiff_t>(corners)) {
        std::vector<std::int32_t> cell(c, c + static_cast<std::ptrdiff_t>(corners));
        std::sort(cell.begin(), cell.end());
        if (cell.front() >= 0) out.insert(cell);
    }
    return out;
}

int all_cells(const annulus_mesh* mesh, size_t capacity, std::int32_t* vertices, size_t* count) {
    return annulus_cells(mesh, capacity, vertices, nullptr, count);
}

template <class Set>
Set without(const Set& a, const Set& b) {
    Set out;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::inserter(out, out.end()));
    return out;
}

/// What each test looks at before and after a call.
struct State {
    State(const annulus_mesh* mesh, std::size_t d)
        : edges(edges_now(mesh)), cells(finite_cells(numbers(mesh, all_cells, d + 1), d + 1)) {}
    std::set<Pair> edges;
    std::set<std::vector<std::int32_t>> cells;
};

void require_edges(const annulus_mesh* mesh, const std::set<Pair>& before, const std::set<Pair>& now) {
    const auto made = without(now, before);
    const auto broken = without(before, now);
    REQUIRE(listed(mesh, annulus_edges_made) == std::vector<Pair>(made.begin(), made.end()));
    REQUIRE(listed(mesh, annulus_edges_broken) == std::vector<Pair>(broken.begin(), broken.end()));
}

/// T1 transitions by their definition, of the triangles and edges that there were and are.
std::vector<std::int32_t> t1_of(const State& before, const State& now) {
    const auto has = [](const State& state, std::vector<std::int32_t> corners) {
        std::sort(corners.begin(), corners.end());
        return state.cells.count(corners) == 1;
    };
    std::vector<std::int32_t> out;
    const auto made = without(now.edges, before.edges);
    for (const auto& [i, j] : without(before.edges, now.edges)) {
        std::vector<std::int32_t> opposite;
        for (const auto& cell : before.cells)
            if (std::count(cell.begin(), cell.end(), i) + std::count(cell.begin(), cell.end(), j) == 2)
                opposite.push_back(cell[0] + cell[1] + cell[2] - i - j);
        std::sort(opposite.begin(), opposite.end());
        if (opposite.size() != 2 || made.count({opposite[0], opposite[1]}) == 0) continue;
        if (has(now, {i, opposite[0], opposite[1]}) && has(now, {j, opposite[0], opposite[1]}))
            out.insert(out.end(), {i, j, opposite[0], opposite[1]});
    }
    return out;
}

annulus_mesh* mesh_of(int d, const std::vector<double>& x, const char* strategy) {
    annulus_options options{};
    options.size = sizeof options;
    options.report_changes = 1;
    options.strategy = strategy;
    annulus_mesh* mesh = nullptr;
    REQUIRE(annulus_create(&mesh, d, x.size() / static_cast<std::size_t>(d), x.data(), &options) == ANNULUS_OK);
    return mesh;
}

std::vector<double> random_points(std::size_t numbers, std::mt19937_64& random) {
    std::vector<double> x(numbers);
    for (double& a : x) a = std::uniform_real_distribution(0.0, 1.0)(random);
    return x;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("C lists the cells and edges that went and came, dimension", "[c]", ((int d), d), 2, 3) {
    for (const char* strategy : {"auto", "tolerances", "rebuild", "relocate-flips"}) {
        CAPTURE(strategy);
        std::mt19937_64 random(5);
        std::vector<double> x = random_points(80 * d, random);
        annulus_mesh* mesh = mesh_of(d, x, strategy);
        std::size_t broken = 0, t1 = 0;
        for (int step = 0; step < 8; ++step) {
            const State before(mesh, d);
            for (double& a : x) a += std::uniform_real_distribution(-0.02, 0.02)(random);
            REQUIRE(annulus_move_all(mesh, x.size() / d, x.data(), nullptr) == ANNULUS_OK);
            const State now(mesh, d);
            require_edges(mesh, before.edges, now.edges);
            // A cell that was turned over is in both lists, with the same corners.
            const auto gone = finite_cells(numbers(mesh, annulus_gone, d + 1), d + 1);
            const auto came = finite_cells(numbers(mesh, annulus_changed, d + 1), d + 1);
            REQUIRE(without(gone, came) == without(before.cells, now.cells));
            REQUIRE(without(came, gone) == without(now.cells, before.cells));
            broken += without(before.edges, now.edges).size();
            if (d == 3) continue;
            const auto transitions = numbers(mesh, annulus_t1, 4);
            REQUIRE(transitions == t1_of(before, now));
            t1 += transitions.size() / 4;
        }
        REQUIRE(broken > 20);
        REQUIRE((d == 3 || (t1 > 10 && t1 < broken)));
        annulus_destroy(&mesh);
    }
}

// Within one call edges are made, broken and made again, and the points may span more or fewer dimensions after it.
TEMPLATE_TEST_CASE_SIG("C lists the edges of calls that change the mesh several times, dimension", "[c]", ((int d), d),
                       2, 3) {
    std::mt19937_64 random(8);
    annulus_mesh* mesh = mesh_of(d, {}, "auto");
    std::vector<std::int32_t> there;
    for (const std::size_t count : {1U, 2U, 9U, 1U, 40U, 30U}) {
        const State before(mesh, d);
        const std::vector<double> x = random_points(count * d, random);
        std::vector<std::int32_t> fresh(count);
        REQUIRE(annulus_insert(mesh, count, x.data(), fresh.data(), nullptr, nullptr) == ANNULUS_OK);
        there.insert(there.end(), fresh.begin(), fresh.end());
        const State now(mesh, d);
        require_edges(mesh, before.edges, now.edges);
        const auto gone = finite_cells(numbers(mesh, annulus_gone, d + 1), d + 1);
        for (const auto& cell : without(before.cells, now.cells))
            if (cell.front() >= 0) REQUIRE(gone.count(cell) == 1);
        if (d == 2) REQUIRE(numbers(mesh, annulus_t1, 4) == t1_of(before, now));
    }
    std::shuffle(there.begin(), there.end(), random);
    for (const std::size_t count : {1U, 30U, 20U, 25U, 7U}) {
        const State before(mesh, d);
        REQUIRE(annulus_remove(mesh, count, there.data() + there.size() - count, nullptr, nullptr) == ANNULUS_OK);
        there.resize(there.size() - count);
        const State now(mesh, d);
        require_edges(mesh, before.edges, now.edges);
        if (d == 2) REQUIRE(numbers(mesh, annulus_t1, 4) == t1_of(before, now));
    }
    REQUIRE(there.empty());
    annulus_destroy(&mesh);
}

TEST_CASE("C has no T1 transitions in 3D", "[c]") {
    annulus_mesh* space = mesh_of(3, {}, "auto");
    std::size_t count = 77;
    REQUIRE(annulus_t1(space, 0, nullptr, &count) == ANNULUS_USAGE);
    REQUIRE(count == 77);
    annulus_destroy(&space);
}
