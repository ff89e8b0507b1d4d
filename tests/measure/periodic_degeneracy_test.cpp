// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/degeneracy.h>
#include <annulus/error.h>
#include <annulus/moving_mesh.h>
#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/repeats.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace annulus;

namespace {

/// Multiples of 2^-20 in the unit box.
template <int d>
std::vector<Coordinates<d>> random_points(std::size_t n, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<Coordinates<d>> x(n);
    for (auto& p : x)
        for (double& c : p) c = std::ldexp(static_cast<double>(random() % (1U << 20)), -20);
    return x;
}

template <int d>
Box<d> unit_box() {
    Coordinates<d> lengths;
    lengths.fill(1);
    return Box<d>::orthorhombic(lengths);
}

/// A certificate by its points, up to translations: ascending numbers, width, theta, the squares of the distances
/// between the places of its points, ascending.
struct Found {
    std::vector<Index> points;
    double width = 0, theta = 0;
    std::vector<double> squares;
};
bool precedes(const Found& a, const Found& b) {
    return a.points != b.points ? a.points < b.points : a.squares < b.squares;
}
bool is_like(const Found& a, const Found& b) {
    return a.points == b.points && a.squares == b.squares &&
           a.width == Approx(b.width).epsilon(1e-3) &&  // ends of enclosures
           a.theta == Approx(b.theta).margin(1e-6);
}
template <int d>
Found found_of(const Raw_certificate<d>& c, Index modulus) {
    Found f{{}, c.width_lower, c.theta, {}};
    for (const Index v : c.point)
        if (v != none) f.points.push_back(v % modulus);
    for (std::size_t i = 0; i < f.points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            double sum = 0;  // exact: coordinates are multiples of 2^-20
            for (std::size_t k = 0; k < d; ++k) sum += std::pow(c.place[i][k] - c.place[j][k], 2);
            f.squares.push_back(sum);
        }
    std::sort(f.points.begin(), f.points.end());
    std::sort(f.squares.begin(), f.squares.end());
    return f;
}

/// The certificates of 5^d copies of the points with open boundaries whose first copy is that in the middle.
template <int d>
std::vector<Found> of_copies(const std::vector<Coordinates<d>>& x) {
    using Tile = std::array<int, static_cast<std::size_t>(d)>;
    std::vector<Coordinates<d>> all;
    std::vector<Tile> tiles;
    for (int t = 0; t < (d == 2 ? 25 : 125); ++t) {
        const Tile tile = [t] {
            Tile result{};
            int rest = t;
            for (int& c : result) {
                c = rest % 5;
                rest /= 5;
            }
            return result;
        }();
        tiles.push_back(tile);
        for (auto p : x) {
            for (std::size_t k = 0; k < d; ++k) p[k] += tile[k];
            all.push_back(p);
        }
    }
    Tile middle;
    middle.fill(2);
    std::vector<Found> result;
    Degeneracy_options<d> options;
    options.raw = [&](const Raw_certificate<d>& c) {
        for (std::size_t i = 0; i < c.point.size(); ++i)
            if (c.point[i] != none) REQUIRE(c.place[i] == all[static_cast<std::size_t>(c.point[i])]);
        Tile first;
        first.fill(9);
        for (const Index v : c.point)
            if (v != none) first = std::min(first, tiles[static_cast<std::size_t>(v) / x.size()]);
        if (first == middle) result.push_back(found_of<d>(c, static_cast<Index>(x.size())));
    };
    (void)degeneracy(Moving_mesh<d>(std::span<const Coordinates<d>>(all)), options);
    std::sort(result.begin(), result.end(), precedes);
    return result;
}

template <int d>
std::vector<Found> of_torus(const Periodic_mesh<d>& mesh, int threads) {
    std::vector<Found> result;
    Degeneracy_options<d> options;
    options.threads = threads;
    options.raw = [&](const Raw_certificate<d>& c) {
        const std::size_t last = c.point.back() == none ? d : d + 1;
        REQUIRE(c.place[last] == mesh.places()[static_cast<std::size_t>(c.point[last])]);
        result.push_back(found_of<d>(c, static_cast<Index>(mesh.index_bound())));
    };
    (void)degeneracy(mesh, options);
    std::sort(result.begin(), result.end(), precedes);
    return result;
}

template <int d>
std::vector<Coordinates<d>> grid(std::size_t side) {
    std::vector<Coordinates<d>> x(d == 2 ? side * side : side * side * side);
    for (std::size_t i = 0; i < x.size(); ++i) {
        std::size_t rest = i;
        for (double& c : x[i]) {
            c = static_cast<double>(rest % side) / static_cast<double>(side);
            rest /= side;
        }
    }
    return x;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("certificates of a periodic mesh are those of many copies, dimension",
                       "[measure][degeneracy][periodic]", ((int d), d), 2, 3) {
    for (int i = 0; i < repeats(3); ++i) {
        const auto x = random_points<d>(static_cast<std::size_t>(20 + 7 * (i % 5)), static_cast<unsigned>(i));
        const Periodic_mesh<d> mesh(x, unit_box<d>());
        const std::vector<Found> found = of_torus(mesh, 1 + i % 2);
        std::vector<Found> expected = of_copies<d>(x);
        // d + 1 half-facets of each cell, and the cell
        CHECK(2 * found.size() == (d + 3) * mesh.number_of_cells());
        REQUIRE(found.size() == expected.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
            // Of the same points there may be several, with different images.
            const auto from = expected.begin() + static_cast<std::ptrdiff_t>(k);
            const auto same = std::find_if(from, expected.end(), [&](const Found& e) { return is_like(found[k], e); });
            REQUIRE(same != expected.end());
            std::iter_swap(from, same);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("a grid in its box: all but the facets of its squares and cubes are degenerate, dimension",
                       "[measure][degeneracy][periodic]", ((int d), d), 2, 3) {
    for (const std::size_t side : {1U, 2U, 4U}) {
        const auto x = grid<d>(side);
        const Periodic_mesh<d> mesh(x, unit_box<d>());
        const Degeneracy r = degeneracy(mesh);
        CHECK(r.periodic);
        CHECK(r.dimension == d);
        CHECK(r.spacing == Approx(1.0 / static_cast<double>(side)).epsilon(1e-14));
        CHECK(r.resolution == mesh.grid()[0]);
        // A square has a diagonal; a cube has facets inside of it, and on each of its sides two triangles.
        const std::uint64_t facets = (d + 1) * mesh.number_of_cells() / 2, sides = (d == 2 ? 2 : 6) * x.size();
        CHECK(r.bicells.least.total == facets);
        CHECK(r.bicells.least.zero == facets - sides);
        CHECK(r.cells.least.total == mesh.number_of_cells());
        CHECK(r.cells.least.zero == 0);
        CHECK(r.ridges.least.total == 0);
        CHECK(r.vertices.total == x.size());
        CHECK(r.vertices.zero == x.size());
        CHECK(r.vertices.paper.histogram.total() == 0);
        CHECK(mesh.audit().degenerate_facets == facets - sides);
    }
}

TEMPLATE_TEST_CASE_SIG("counts in a box depend on its lattice, not on its basis, dimension",
                       "[measure][degeneracy][periodic]", ((int d), d), 2, 3) {
    auto vectors = unit_box<d>().vectors();
    vectors[1][0] = 7;  // as skewed as a box may be
    if (d == 3) {
        vectors[2][0] = -5;
        vectors[2][1] = 6;
    }
    for (const auto& x : {random_points<d>(30, 4), grid<d>(4)}) {
        const Degeneracy upright = degeneracy(Periodic_mesh<d>(x, unit_box<d>()));
        const Periodic_mesh<d> mesh(x, Box<d>(vectors));
        const Degeneracy skewed = degeneracy(mesh);
        CHECK(skewed.bicells.least.total == upright.bicells.least.total);
        CHECK(skewed.bicells.least.zero == upright.bicells.least.zero);
        CHECK(skewed.bicells.least.below == upright.bicells.least.below);
        CHECK(skewed.bicells.least.width.quantiles[5] ==
              Approx(upright.bicells.least.width.quantiles[5]).epsilon(1e-3));
        CHECK(skewed.cells.least.below == upright.cells.least.below);
        CHECK(skewed.vertices.below == upright.vertices.below);
        CHECK(mesh.audit().degenerate_facets == skewed.bicells.least.zero);
    }
}

TEST_CASE("a periodic mesh without points has no degeneracy, and removed vertices do not count",
          "[measure][degeneracy][periodic]") {
    Periodic_mesh<2> mesh(random_points<2>(20, 1), unit_box<2>());
    mesh.remove(4);
    const Degeneracy r = degeneracy(mesh);
    CHECK(r.vertices.total == 19);
    CHECK(r.bicells.least.total == 57);
    CHECK(r.spacing == Approx(std::sqrt(1.0 / 19)));
    CHECK_THROWS_AS(degeneracy(mesh, {.threads = 0}), Error);
    CHECK_THROWS_AS(degeneracy(Periodic_mesh<2>({}, unit_box<2>())), Error);
}
