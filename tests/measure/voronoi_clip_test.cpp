// SPDX-License-Identifier: GPL-3.0-or-later
// Voronoi cells that are clipped, compared with cells cut out in rational numbers (facet_oracle.h).
#include <annulus/error.h>
#include <annulus/moving_mesh.h>
#include <annulus/voronoi.h>
#include <measure/facet_oracle.h>
#include <support/catch.h>
#include <support/generators.h>
#include <support/meshes.h>
#include <support/repeats.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

using namespace annulus;
using namespace annulus::testing;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What is promised of a clipped diagram, with `length` the diameter of clip and points.
template <int d>
void check_clipped(const Points_d<d>& x, const Voronoi_clip<d>& clip, double length) {
    const Moving_mesh<d> mesh{std::span<const Coordinates<d>>(x)};
    const Voronoi_diagram<d> diagram = voronoi(mesh, clip);
    std::map<std::array<Index, 2>, std::size_t> number;
    for (std::size_t k = 0; k < diagram.pair.size(); ++k) number[diagram.pair[k]] = k;
    const double off = 0x1p-44 * std::pow(length, d);
    for (std::size_t v = 0; v < x.size(); ++v) {
        const auto cell = exact_polytope<d>(x, v, &clip);
        double surface = 0;
        for (const auto& side : cell.sides) surface += std::sqrt(side.square.get_d());
        CAPTURE(v, cell.volume.get_d(), diagram.volume[v], surface, diagram.surface[v]);
        const double sides = static_cast<double>(mesh.neighbors(static_cast<Index>(v)).size());
        REQUIRE(std::fabs(diagram.volume[v] - cell.volume.get_d()) <=
                off + 2 * voronoi_diagram_error * diagram.volume[v]);
        REQUIRE(std::fabs(diagram.surface[v] - surface) <= 1e-9 * std::pow(length, d - 1) * sides);
        if (cell.volume > mpq_class(0x1p-10 * std::pow(length, d)))
            for (std::size_t a = 0; a < d; ++a)
                REQUIRE(std::fabs(diagram.cell_centroid[v][a] - cell.centroid[a].get_d()) <= 1e-9 * length);
        for (std::size_t other = v + 1; other < x.size(); ++other) {
            const auto found = number.find({static_cast<Index>(v), static_cast<Index>(other)});
            const auto& side = cell.sides[other - 1];
            const double truth = std::sqrt(side.square.get_d());
            CAPTURE(other, truth);
            if (found == number.end()) REQUIRE(truth == 0);
            else {
                const std::size_t k = found->second;
                CAPTURE(diagram.measure[k]);
                REQUIRE(std::fabs(diagram.measure[k] - truth) <=
                        1e-10 * std::pow(length, d - 1) + 2 * voronoi_diagram_error * truth);
                REQUIRE(std::isnan(diagram.centroid[k][0]) == (diagram.measure[k] == 0));
            }
        }
    }
}

/// The sine of the angle between the planes with these normals.
template <int d>
double sine(const Coordinates<d>& a, const Coordinates<d>& b) {
    double square = 0;
    double lengths = 1;
    for (const auto& v : {a, b}) {
        double length = 0;
        for (const double c : v) length += c * c;
        lengths *= length;
    }
    for (std::size_t k = 0; k < d; ++k)
        for (std::size_t i = 0; i < k; ++i) square += std::pow(a[i] * b[k] - a[k] * b[i], 2);
    return std::sqrt(square / lengths);
}

/// The largest error of a measure in a clip that is a box, in 2^-46 L^(d-1), and the largest with the promise's factor.
template <int d>
std::array<double, 2> worst_facet(const Points_d<d>& x, const Voronoi_clip<d>& clip, double length) {
    const Moving_mesh<d> mesh{std::span<const Coordinates<d>>(x)};
    const auto diagram = voronoi(mesh, clip);
    std::array<double, 2> worst{};
    for (std::size_t k = 0; k < diagram.pair.size(); ++k) {
        const Index i = diagram.pair[k][0], j = diagram.pair[k][1];
        double least = 1;
        const auto to = [&](Index v) {
            Coordinates<d> e = x[static_cast<std::size_t>(v)];
            for (std::size_t a = 0; a < d; ++a) e[a] -= x[static_cast<std::size_t>(i)][a];
            return e;
        };
        for (const Index other : mesh.neighbors(i))
            if (other != j) least = std::min(least, sine<d>(diagram.vector[k], to(other)));
        for (std::size_t a = 0; a < d; ++a) {
            Coordinates<d> axis{};
            axis[a] = 1;
            least = std::min(least, sine<d>(diagram.vector[k], axis));
        }
        const auto cell = exact_polytope<d>(x, static_cast<std::size_t>(i), &clip);
        const double truth = std::sqrt(cell.sides[static_cast<std::size_t>(j) - 1].square.get_d());
        const double error = std::fabs(diagram.measure[k] - truth) / (0x1p-46 * std::pow(length, d - 1));
        worst[0] = std::max(worst[0], error);
        worst[1] = std::max(worst[1], error * least);
    }
    return worst;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("A box makes all cells finite, and they fill it, dimension", "[measure][voronoi]", ((int d), d),
                       2, 3) {
    for (int i = 0; i < repeats(4); ++i) {
        const auto seed = static_cast<std::uint64_t>(7000 + i);
        Random random(seed);
        const Points_d<d> x = uniform<d>(d == 2 ? 30 : 16, random);
        INFO("seed " << seed);
        Voronoi_clip<d> clip;
        clip.lower.fill(i % 2 == 0 ? 0 : 0.25);  // with points outside, too
        clip.upper.fill(i % 3 == 0 ? 1 : 0.75);
        check_clipped<d>(x, clip, 2);
        double sum = 0;
        for (const double v :
             voronoi_diagram<d>(x, Moving_mesh<d>{std::span<const Coordinates<d>>(x)}.cells(), &clip).volume)
            sum += v;
        CHECK(sum == Approx(std::pow(clip.upper[0] - clip.lower[0], d)).epsilon(1e-12));
        clip.half_spaces.push_back({{1, 1}, 1.1});
        clip.half_spaces.push_back({{-3, 1}, 0.1});
        check_clipped<d>(x, clip, 2);
    }
}

TEMPLATE_TEST_CASE_SIG("Lattices and flat points are clipped, too, dimension", "[measure][voronoi]", ((int d), d), 2,
                       3) {
    Random random(13);
    Points_d<d> lattice;
    for (int i = 0; i < (d == 2 ? 16 : 27); ++i) {
        const int side = d == 2 ? 4 : 3;
        auto& p = lattice.emplace_back();
        for (int k = 0, rest = i; k < d; ++k, rest /= side) p[static_cast<std::size_t>(k)] = rest % side;
    }
    Voronoi_clip<d> clip;
    for (const double margin : {0.5, 0.25, -0.25, 3.0}) {
        clip.lower.fill(-margin);
        clip.upper.fill((d == 2 ? 3 : 2) + margin);
        CAPTURE(margin);
        check_clipped<d>(lattice, clip, 10);
    }
    clip.lower.fill(0.5);  // in the planes of facets
    clip.upper.fill(1.5);
    const auto diagram = voronoi(Moving_mesh<d>{std::span<const Coordinates<d>>(lattice)}, clip);
    Coordinates<d> one_and_one;
    one_and_one.fill(1);
    for (std::size_t v = 0; v < lattice.size(); ++v)
        CHECK(diagram.volume[v] == Approx(lattice[v] == one_and_one ? 1 : 0).margin(1e-14));
    for (auto& p : lattice)
        for (double& c : p) c += between(random, -1e-10, 1e-10);
    double sum = 0;
    for (const double v : voronoi(Moving_mesh<d>{std::span<const Coordinates<d>>(lattice)}, clip).volume) sum += v;
    CHECK(sum == Approx(1).epsilon(1e-13));

    Points_d<d> flat;
    for (int i = 0; i < 9; ++i) flat.push_back({0.1 * i, d == 3 ? 0.1 * (i % 3) : 0.0});
    clip.lower.fill(-1);
    clip.upper.fill(1);
    check_clipped<d>(flat, clip, 4);
    flat.resize(2);
    check_clipped<d>(flat, clip, 4);
    flat.resize(1);  // the only vertex
    const Moving_mesh<d> one{std::span<const Coordinates<d>>(flat)};
    CHECK(voronoi(one, clip).volume.at(0) == Approx(std::pow(2.0, d)));
    CHECK(voronoi(one).volume == std::vector<double>{infinity});
}

TEMPLATE_TEST_CASE_SIG("Facets whose planes nearly coincide are as far off as their angle is small, dimension",
                       "[measure][voronoi]", ((int d), d), 2, 3) {
    Voronoi_clip<d> clip;
    clip.lower.fill(0);
    clip.upper.fill(1);
    double worst = 0;
    for (int i = 0; i < repeats(3); ++i)
        for (const int digits : {3, 6, 9, 11, 13}) {
            const auto seed = static_cast<std::uint64_t>(7100 + 20 * i + digits);
            Random random(seed);
            Points_d<d> x = uniform<d>(8, random);
            for (int twin = 0; twin < 2; ++twin) {  // near one of the first
                x.push_back(x[random() % 4]);
                for (double& c : x.back()) c += between(random, -1, 1) * std::pow(10.0, -digits);
            }
            INFO("seed " << seed);
            const auto [error, promised] = worst_facet<d>(x, clip, std::sqrt(d));
            CHECK(promised <= 1);
            worst = std::max(worst, error);
        }
    CHECK(worst > 0x1p13);  // so that a bound without the angle would be wrong
}
