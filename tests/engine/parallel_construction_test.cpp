// SPDX-License-Identifier: GPL-3.0-or-later
// A construction does not depend on the number of threads.
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/moving_mesh.h>

#include <support/catch.h>
#include <support/viewed_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <utility>
#include <vector>

using namespace annulus;

namespace {

template <int d>
using Points = std::vector<Coordinates<d>>;

/// More points and cells than a run of any kind has.
template <int d>
constexpr std::size_t many = d == 2 ? 30000 : 17000;

template <int d>
Points<d> uniform() {
    std::mt19937_64 bits(11);
    Points<d> x(many<d>);
    for (auto& p : x)
        for (double& c : p) c = static_cast<double>(bits() >> 11) * 0x1p-53;
    return x;
}

/// Integers in random order: many points share a coordinate, and many cells a circumcentre.
template <int d>
Points<d> lattice() {
    const std::size_t side = d == 2 ? 174 : 26;
    Points<d> x;
    std::size_t all = 1;
    for (int k = 0; k < d; ++k) all *= side;
    for (std::size_t i = 0; i < all; ++i) {
        std::size_t rest = i * 7919 % all;
        Coordinates<d>& p = x.emplace_back();
        for (double& c : p) {
            c = static_cast<double>(rest % side);
            rest /= side;
        }
    }
    return x;
}

/// Also checks that the corner stored for a vertex is its largest, independently of the order of runs.
template <int d>
void say_table(const Corner_table<d>& table, std::vector<std::int64_t>& said) {
    std::vector<Corner_index> largest(static_cast<std::size_t>(table.vertex_bound()));
    Corner_index largest_of_infinity;
    for (const Cell_index c : table.cells())
        for (int i = 0; i <= d; ++i) {
            const Corner_index h = table.corner(c, i);
            const Index v = table.vertex(h);
            (v == infinite ? largest_of_infinity : largest[static_cast<std::size_t>(v)]) = h;
            said.insert(said.end(), {h.value(), v, table.twin(h).value()});
        }
    bool are_noted = table.corner_of_infinity() == largest_of_infinity;
    for (Index v = 0; v < table.vertex_bound(); ++v)
        are_noted = are_noted && table.corner_of(v) == largest[static_cast<std::size_t>(v)];
    CHECK(are_noted);
}

/// Cells, corners, neighbours and tolerances of both classes after construction, and after every vertex has moved to
/// the old position of another, which is a rebuild.
template <int d>
std::pair<std::vector<std::int64_t>, std::vector<double>> built(Points<d> x, Strategy strategy, int threads) {
    Options options;
    options.strategy = strategy;
    options.threads = threads;
    Moving_mesh<d> mesh(std::span<const Coordinates<d>>(x), options);
    testing::Viewed_mesh<d> dt(std::span<const Coordinates<d>>(x), options);
    std::vector<std::int64_t> cells;
    std::vector<double> tolerances;
    const auto say = [&] {
        const Mesh_cells<d> all = mesh.cells();
        for (const auto& c : all.vertices) cells.insert(cells.end(), c.begin(), c.end());
        for (const auto& c : all.neighbours) cells.insert(cells.end(), c.begin(), c.end());
        for (const auto& c : dt.audit_input().cells) cells.insert(cells.end(), c.begin(), c.end());
        say_table<d>(dt.mesh().table(), cells);
        for (std::size_t i = 0; i < x.size(); i += 64) {
            tolerances.push_back(mesh.tolerance(static_cast<Index>(i)));
            tolerances.push_back(dt.tolerance(static_cast<Index>(i)));
        }
    };
    say();
    std::rotate(x.begin(), x.begin() + 1, x.end());
    for (const Move_result& r :
         {mesh.move_all(std::span<const Coordinates<d>>(x)), dt.move_all(std::span<const Coordinates<d>>(x))})
        CHECK(r.moves.rebuilt == x.size());
    say();
    return {cells, tolerances};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("What several threads build is what one builds, bit for bit, dimension", "[parallel][deep]",
                       ((int d), d), 2, 3) {
    const auto compare = [](const Points<d>& x, Strategy strategy) {
        const auto alone = built<d>(x, strategy, 1);
        for (const int threads : {2, 5}) CHECK((built<d>(x, strategy, threads) == alone));
    };
    compare(uniform<d>(), Strategy::rebuild);
    compare(uniform<d>(), Strategy::tolerances);
    compare(lattice<d>(), Strategy::rebuild);
}
