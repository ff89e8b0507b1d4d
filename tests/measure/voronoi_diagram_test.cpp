// SPDX-License-Identifier: GPL-3.0-or-later
// Facets and cells of Voronoi diagrams compared with cells cut out in rational numbers (facet_oracle.h), for points of
// every kind.
#include <annulus/error.h>
#include <annulus/measure/circumcentre.h>
#include <annulus/moving_mesh.h>
#include <annulus/voronoi.h>
#include <measure/facet_oracle.h>
#include <support/catch.h>
#include <support/meshes.h>
#include <support/point_sets_3.h>
#include <support/repeats.h>

#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

using namespace annulus;
using namespace annulus::testing;

namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// |value - sqrt(square)| <= relative sqrt(square), and the guarantee at the ends of the range of doubles.
bool is_root(double value, const mpq_class& square, double relative) {
    if (!(value >= 0) || std::isinf(value)) return false;
    const mpq_class exactly(value);
    if (value == largest && square > exactly * exactly) return true;
    mpq_class least = value < 0x1p-1021 ? 1 : 0;
    least >>= 1074;
    const mpq_class above = exactly * (1 + mpq_class(relative)) + least;
    mpq_class below = exactly * (1 - mpq_class(relative)) - least;
    if (sgn(below) < 0) below = 0;
    return below * below <= square && square <= above * above;
}
bool is_near(double value, const mpq_class& truth, double relative) {
    return sgn(truth) >= 0 && is_root(value, truth * truth, relative);
}

template <int d>
double reach(const Voronoi_diagram<d>& diagram, std::size_t k, const Coordinates<d>& from) {
    double most = 0;
    for (Index r = diagram.ring_begin[k]; r < diagram.ring_begin[k + 1]; ++r)
        if (const Index c = diagram.ring[at(r)]; c >= 0) {
            double far = 0;
            for (std::size_t a = 0; a < d; ++a) far = std::hypot(far, diagram.vertex[at(c)][a] - from[a]);
            most = std::max(most, far);
        }
    return most;
}

template <int d>
bool is_near(const Coordinates<d>& p, const std::array<mpq_class, static_cast<std::size_t>(d)>& truth, double reach) {
    double size = 0;
    for (const double c : p) size = std::max(size, std::fabs(c));
    if (!(reach < largest)) return true;
    const mpq_class off = mpq_class(0x1p-30 * reach + 0x1p-52 * size);
    for (std::size_t k = 0; k < d; ++k)
        if (!std::isfinite(p[k]) || abs(mpq_class(p[k]) - truth[k]) > off + mpq_class(0x1p-1070)) return false;
    return true;
}

/// Whether a Voronoi vertex is where the circumcentre of its cell is.
template <int d>
void check_vertex(const Points_d<d>& x, const std::array<Index, static_cast<std::size_t>(d + 1)>& cell,
                  const Coordinates<d>& vertex) {
    std::array<std::array<mpq_class, static_cast<std::size_t>(d)>, static_cast<std::size_t>(d)> edge;
    double shortest = infinity;
    double size = 0;
    for (std::size_t i = 0; i <= d; ++i) {
        for (const double c : x[at(cell[i])]) size = std::max(size, std::fabs(c));
        for (std::size_t j = 0; j < i; ++j) {
            double length = 0;
            for (std::size_t a = 0; a < d; ++a) length = std::hypot(length, x[at(cell[i])][a] - x[at(cell[j])][a]);
            shortest = std::min(shortest, length);
        }
        for (std::size_t a = 0; a < d && i > 0; ++a) {
            edge[i - 1][a] = x[at(cell[i])][a];
            edge[i - 1][a] -= x[at(cell[0])][a];
        }
    }
    const auto terms = [&edge] {
        if constexpr (d == 2) return Circumcentre_2<mpq_class>(edge[0], edge[1]);
        else return Circumcentre_3<mpq_class>(edge[0], edge[1], edge[2]);
    }();
    mpq_class radius = 0;
    for (std::size_t a = 0; a < d; ++a) radius += abs(terms.numerator[a] / (2 * terms.denominator));
    if (radius > mpq_class(largest)) return;
    mpq_class allowed = 0x1p-40 * shortest;
    allowed = std::max(allowed, mpq_class(0x1p-50 * radius)) + mpq_class(0x1p-52 * size) + mpq_class(0x1p-1070);
    for (std::size_t a = 0; a < d; ++a) {
        const mpq_class truth = x[at(cell[0])][a] + terms.numerator[a] / (2 * terms.denominator);
        REQUIRE(abs(mpq_class(vertex[a]) - truth) <= allowed);
    }
}

/// Every pair and every cell; the pairs are all that have a facet. Returns the number of empty facets.
template <int d>
std::size_t check_all(const Points_d<d>& x) {
    const Moving_mesh<d> mesh{std::span<const Coordinates<d>>(x)};
    const Voronoi_diagram<d> diagram = voronoi(mesh);
    REQUIRE(std::is_sorted(diagram.pair.begin(), diagram.pair.end()));
    REQUIRE(diagram.pair.size() == mesh.vertex_neighbors()->index.size() / 2);
    std::map<std::array<Index, 2>, std::size_t> number;
    for (std::size_t k = 0; k < diagram.pair.size(); ++k) number[diagram.pair[k]] = k;
    std::size_t empty = 0;
    for (std::size_t c = 0; c < diagram.vertex.size(); ++c)
        check_vertex<d>(x, mesh.cell_lists()->cells.vertices[c], diagram.vertex[c]);
    for (std::size_t v = 0; v < x.size(); ++v) {
        const auto cell = exact_polytope<d>(x, v);
        bool bounded = true;
        double surface = 0;
        double far = 0;
        for (std::size_t p = 0; p + 1 < x.size(); ++p) {
            const std::size_t other = p < v ? p : p + 1;
            const auto& side = cell.sides[p];
            CAPTURE(v, other);
            const auto found =
                number.find({static_cast<Index>(std::min(v, other)), static_cast<Index>(std::max(v, other))});
            if (found == number.end()) {
                REQUIRE(side.bounded);
                REQUIRE(sgn(side.square) == 0);
                continue;
            }
            const std::size_t k = found->second;
            far = std::max(far, reach<d>(diagram, k, x[v]));
            bounded = bounded && side.bounded;
            if (mesh.dimension() < d) {
                REQUIRE(diagram.measure[k] == infinity);
                continue;
            }
            CAPTURE(diagram.measure[k]);
            REQUIRE((diagram.exactly_empty[k] != 0) == (side.bounded && sgn(side.square) == 0));
            if (other > v) empty += at(diagram.exactly_empty[k]);
            if (!side.bounded) REQUIRE(diagram.measure[k] == infinity);
            else {
                REQUIRE(is_root(diagram.measure[k], side.square, voronoi_diagram_error));
                if (sgn(side.square) > 0)
                    REQUIRE(is_near<d>(diagram.centroid[k], side.centroid, reach<d>(diagram, k, x[v])));
                surface += diagram.measure[k];
            }
        }
        if (mesh.dimension() < d) continue;
        CAPTURE(v, diagram.volume[v]);
        if (!bounded || std::isinf(diagram.volume[v])) {
            REQUIRE(!bounded);
            REQUIRE((diagram.volume[v] == infinity && diagram.surface[v] == infinity));
            REQUIRE(std::isnan(diagram.cell_centroid[v][0]));
            continue;
        }
        REQUIRE(is_near(diagram.volume[v], cell.volume, voronoi_diagram_error));
        REQUIRE(is_near<d>(diagram.cell_centroid[v], cell.centroid, far));
        if (surface < largest) REQUIRE(diagram.surface[v] == Approx(surface).epsilon(1e-14));
    }
    return empty;
}

/// The neighbours of the point in the middle of a lattice that share a facet with it.
template <int d>
std::size_t true_neighbours(const Points_d<d>& x, Index middle) {
    const Moving_mesh<d> mesh{std::span<const Coordinates<d>>(x)};
    const auto diagram = voronoi(mesh);
    std::size_t count = 0;
    for (std::size_t k = 0; k < diagram.pair.size(); ++k)
        if (diagram.pair[k][0] == middle || diagram.pair[k][1] == middle)
            count += diagram.exactly_empty[k] == 0 ? 1 : 0;
    return count;
}

}  // namespace

TEST_CASE("Edges and cells of 2D Voronoi diagrams are those cut out exactly, points of every kind",
          "[measure][voronoi]") {
    std::size_t empty = 0;
    for (int i = 0; i < repeats(3); ++i)
        for (const Family family : all_families) {
            const auto seed = static_cast<std::uint64_t>(5000 + i);
            Random random(seed);
            const Points x = point_set(family, 6 + random() % 20, random);
            INFO(name_of(family) << ", seed " << seed << "\n" << as_code(x));
            empty += check_all<2>(x);
        }
    CHECK(empty >= 5);  // of each repetition, 9 and more
}

TEST_CASE("Facets and cells of 3D Voronoi diagrams are those cut out exactly, points of every kind",
          "[measure][voronoi]") {
    std::size_t empty = 0;
    for (int i = 0; i < repeats(1); ++i)
        for (const Set_3 set : all_sets_3) {
            const auto seed = static_cast<std::uint64_t>(6000 + i);
            Random random(seed);
            const Points_3 x = point_set(set, 7 + random() % 7, random);
            INFO(name_of(set) << ", seed " << seed << "\n" << as_code(x));
            empty += check_all<3>(x);
        }
    CHECK(empty >= 5);  // of each repetition, 9 and more
}

TEST_CASE("Facets of lattices are counted exactly: 4, 6 and 12 neighbours", "[measure][voronoi]") {
    Points square;
    Points_3 cubic;
    Points_3 fcc;
    for (int i = 0; i < 125; ++i) {
        const double a = i % 5;
        const double b = i / 5 % 5;
        const double c = i / 25;
        if (i < 25) square.push_back({0.1 * a, 0.1 * b});  // not exactly a lattice
        cubic.push_back({a, b, c});
        fcc.push_back({a, b, c});
        for (int k = 0; k < 3; ++k)
            fcc.push_back({a + (k != 0 ? 0.5 : 0), b + (k != 1 ? 0.5 : 0), c + (k != 2 ? 0.5 : 0)});
    }
    CHECK(true_neighbours<3>(cubic, 62) == 6);
    CHECK(true_neighbours<3>(fcc, 4 * 62) == 12);
    (void)check_all<2>(square);
    for (auto& p : square) p = {8 * std::round(10 * p[0]), 8 * std::round(10 * p[1])};
    CHECK(true_neighbours<2>(square, 12) == 4);
    // Noise of one part in 10^10 makes facets where there were none, and they are as accurate as others.
    Random random(7);
    Points_3 small(cubic.begin(), cubic.begin() + 27);
    for (int i = 0; i < 27; ++i) small[static_cast<std::size_t>(i)] = {double(i % 3), double(i / 3 % 3), double(i / 9)};
    CHECK(check_all<3>(small) > 20);
    for (auto& p : small)
        for (double& c : p) c += between(random, -1e-10, 1e-10);
    CHECK(check_all<3>(small) == 0);
}
