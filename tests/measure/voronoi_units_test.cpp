// SPDX-License-Identifier: GPL-3.0-or-later
// Clips of Voronoi cells that are far away, of any size and in any unit; half-spaces and the box around them.
#include <annulus/error.h>
#include <annulus/moving_mesh.h>
#include <annulus/voronoi.h>
#include <support/catch.h>
#include <support/generators.h>
#include <support/meshes.h>

#include <cmath>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

/// The same diagram in another unit, 2^exponent, and with normals times 2^power.
void check_units(int exponent, int power) {
    CAPTURE(exponent, power);
    Random random(15);
    Points x = uniform<2>(20, random);
    for (auto& p : x)
        for (double& c : p) c = std::ldexp(std::round(std::ldexp(c, 20)), -20);
    Voronoi_clip<2> clip{{0.25, 0}, {1, 0.75}, {{{1, 1}, 1.25}, {{-3, 1}, 0.125}}};
    const auto usual = voronoi(Moving_mesh<2>{std::span<const Coordinates<2>>(x)}, clip);
    for (auto& p : x)
        for (double& c : p) c = std::ldexp(c, exponent);
    for (auto* corner : {&clip.lower, &clip.upper})
        for (double& c : *corner) c = std::ldexp(c, exponent);
    for (auto& h : clip.half_spaces) {
        for (double& c : h.normal) c = std::ldexp(c, power);
        h.offset = std::ldexp(h.offset, power + exponent);
    }
    const auto other = voronoi(Moving_mesh<2>{std::span<const Coordinates<2>>(x)}, clip);
    REQUIRE(other.pair == usual.pair);
    for (std::size_t k = 0; k < usual.pair.size(); ++k) {
        CHECK(other.measure[k] == std::ldexp(usual.measure[k], exponent));
        CHECK(other.distance[k] == std::ldexp(usual.distance[k], exponent));
    }
    for (std::size_t v = 0; v < x.size(); ++v) {
        CHECK(other.surface[v] == std::ldexp(usual.surface[v], exponent));
        CHECK(other.volume[v] == std::ldexp(usual.volume[v], 2 * exponent));
    }
}

/// The simplex that begins at (distance, .., distance) with edges of this length.
template <int d>
std::vector<Half_space<d>> corner_of(double distance, double length) {
    std::vector<Half_space<d>> out;
    for (std::size_t k = 0; k < d; ++k) {
        out.push_back({{}, -distance});
        out.back().normal[k] = -1;
    }
    out.push_back({{}, d * distance + length});
    out.back().normal.fill(1);
    return out;
}

}  // namespace

TEST_CASE("The region of half-spaces has the box around it, or is refused", "[measure][voronoi]") {
    const std::vector<Half_space<2>> triangle{{{-1, 0}, 0}, {{0, -2}, 0}, {{1, 1}, 1}};
    const auto clip = voronoi_clip<2>(triangle);
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK((clip.lower[k] < 0 && clip.lower[k] > -1e-9));
        CHECK((clip.upper[k] > 1 && clip.upper[k] < 1 + 1e-9));
    }
    const std::vector<Half_space<2>> open{{{-1, 0}, 0}, {{1, 1}, 1}};
    CHECK_THROWS_AS(voronoi_clip<2>(open), Error);
    const std::vector<Half_space<2>> none_in_common{{{-1, 0}, -2}, {{0, -2}, 0}, {{1, 1}, 1}};
    CHECK_THROWS_AS(voronoi_clip<2>(none_in_common), Error);
    CHECK_THROWS_AS(voronoi_clip<2>({}), Error);
    CHECK_THROWS_AS(voronoi_clip<2>(std::vector<Half_space<2>>{{{0, 0}, 1}}), Error);
    CHECK_THROWS_AS(voronoi_clip<2>(std::vector<Half_space<2>>{{{NAN, 0}, 1}}), Error);
    const Points x{{0, 0}, {1, 0}, {0, 1}};
    const Moving_mesh<2> mesh{std::span<const Coordinates<2>>(x)};
    CHECK_THROWS_AS(voronoi(mesh, {{0, 0}, {0, 1}, {}}), Error);
    CHECK_THROWS_AS(voronoi(mesh, {{0, 0}, {1, NAN}, {}}), Error);
    CHECK_THROWS_AS(voronoi(mesh, {{0, 0}, {1, 1}, {{{0, 0}, 1}}}), Error);
}

TEMPLATE_TEST_CASE_SIG("Half-spaces may be far from the origin, and in any unit, dimension", "[measure][voronoi]",
                       ((int d), d), 2, 3) {
    const double whole = d == 2 ? 0.5 : 1.0 / 6;
    for (const double distance : {0.0, 1.0, -1e5, 1e10, -1e15}) {
        CAPTURE(distance);
        auto planes = corner_of<d>(distance, 1);
        planes.push_back({{0x1p-1000, 0x1p-1010}, 1});  // farther away than all others
        const auto clip = voronoi_clip<d>(planes);
        for (std::size_t k = 0; k < d; ++k) {
            CHECK((clip.lower[k] < distance && clip.lower[k] > distance - 1e-9 - 0x1p-51 * std::fabs(distance)));
            CHECK(
                (clip.upper[k] > distance + 1 && clip.upper[k] < distance + 1 + 1e-9 + 0x1p-51 * std::fabs(distance)));
        }
        Points_d<d> x(1);
        const auto one = voronoi(Moving_mesh<d>{std::span<const Coordinates<d>>(x)}, clip);
        CHECK(one.volume.at(0) == Approx(whole).epsilon(1e-14));
        CHECK(one.cell_centroid.at(0)[0] == Approx(distance + 1.0 / (d + 1)).epsilon(1e-14));
    }
    for (const double size : {0x1p-1070, 0x1p-600, 1e160, 0x1p990}) {
        const auto clip = voronoi_clip<d>(corner_of<d>(0, size));
        for (std::size_t k = 0; k < d; ++k) {
            CHECK((clip.lower[k] <= 0 && clip.lower[k] > -1e-9 * size - 0x1p-1073));
            CHECK((clip.upper[k] >= size && clip.upper[k] < (1 + 1e-9) * size + 0x1p-1073));
        }
    }
    CHECK_THROWS_AS(voronoi_clip<d>(corner_of<d>(0, 0)), Error);
    CHECK_THROWS_AS(voronoi_clip<d>(corner_of<d>(1, 0)), Error);
    CHECK_THROWS_AS(voronoi_clip<d>(corner_of<d>(1e10, -1e-5)), Error);
    CHECK_THROWS_AS(voronoi_clip<d>(corner_of<d>(0, 0x1p1005)), Error);
}

TEST_CASE("A clipped diagram has the same bits in any unit, and with normals of any length", "[measure][voronoi]") {
    for (const int exponent : {0, -500, -900, 450}) check_units(exponent, 0);
    for (const int power : {-1060, -500, 500, 1000}) check_units(0, power);
    check_units(-540, -400);
    check_units(450, 570);
    // Bisectors of points that are closer than a unit about the size of the clip can hold.
    const Points pair{{0, 0}, {0x1p-1073, 0x1p-1074}};
    const Voronoi_clip<2> box{{-1, -1}, {1, 1}, {}};
    const auto diagram = voronoi(Moving_mesh<2>{std::span<const Coordinates<2>>(pair)}, box);
    CHECK(diagram.volume[0] == Approx(2));
    CHECK(diagram.volume[1] == Approx(2));
    CHECK(diagram.measure[0] == Approx(std::sqrt(5.0)));
}
