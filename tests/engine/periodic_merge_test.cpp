// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic_options::merge_duplicates: points that are images of one another are one vertex.
#include <annulus/error.h>
#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/cells_of_periodic.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

/// Vectors with few digits, so that images are exact.
template <int d>
typename Box<d>::Vectors vectors(int kind) {
    typename Box<d>::Vectors v{};
    for (std::size_t i = 0; i < d; ++i) v[i][i] = 1.0 + static_cast<double>(i) / 4;
    if (kind == 1) v[1][0] = 0.5;
    if (kind == 2) v[d - 1][0] = -3;
    if (kind == 3) v[0][0] = 1.0 / 64;
    return v;
}

/// Points of a coarse grid, on the sides and corners of the box, too, in any order and as any images.
template <int d>
void expect_merged(int kind, std::uint64_t seed) {
    CAPTURE(d, kind, seed);
    Periodic_cases cases(seed);
    const auto v = vectors<d>(kind);
    std::vector<std::array<std::int64_t, static_cast<std::size_t>(d)>> names;  // in quarters of the vectors
    std::vector<Coordinates<d>> x, distinct;
    std::vector<Index> of;
    for (int k = 0; k < 60; ++k) {
        auto& name = names.emplace_back();
        Coordinates<d> p{};
        for (std::size_t j = 0; j < d; ++j) {
            const auto quarters = static_cast<std::int64_t>(cases.below(40)) - 20;
            name[j] = (quarters % 4 + 4) % 4;
            for (std::size_t i = 0; i < d; ++i) p[i] += static_cast<double>(quarters) / 4 * v[j][i];
        }
        x.push_back(p);
        const auto first = std::find(names.begin(), names.end(), name);
        if (first == names.end() - 1) {
            of.push_back(static_cast<Index>(distinct.size()));
            distinct.push_back(p);
        } else {
            of.push_back(of[static_cast<std::size_t>(first - names.begin())]);
        }
    }
    const Box<d> box(v);
    const Periodic_mesh<d> mesh(x, box, {.merge_duplicates = true});
    CHECK(mesh.number_of_vertices() == distinct.size());
    CHECK(std::equal(of.begin(), of.end(), mesh.vertex_of_input().begin(), mesh.vertex_of_input().end()));
    CHECK(cells_of(mesh) == cells_of(Periodic_mesh<d>(distinct, box)));
    CHECK(std::equal(distinct.begin(), distinct.end(), mesh.points().begin(), mesh.points().end()));
    CHECK(mesh.audit().delaunay());
    CHECK_THROWS_AS(Periodic_mesh<d>(x, box), Error);
}

}  // namespace

TEST_CASE("Points that are images of one another are one vertex on request", "[periodic]") {
    for (int kind = 0; kind < 4; ++kind)
        for (int k = 0; k < repeats(4); ++k) {
            expect_merged<2>(kind, static_cast<std::uint64_t>(k));
            expect_merged<3>(kind, static_cast<std::uint64_t>(k));
        }
}

TEST_CASE("Points on both sides of a box, as it rounds, are one vertex on request", "[periodic]") {
    const std::vector<Coordinates<2>> x{{0, 0}, {-1e-30, 0}, {1, 1}, {0.5, 0.5}, {3, -1e-30}, {0.5, -0.5}};
    const auto box = Box<2>::orthorhombic({1, 1});
    const Periodic_mesh<2> mesh(x, box, {.merge_duplicates = true});
    CHECK(mesh.number_of_vertices() == 2);
    const std::vector<Index> of{0, 0, 0, 1, 0, 1};
    CHECK(std::equal(of.begin(), of.end(), mesh.vertex_of_input().begin(), mesh.vertex_of_input().end()));
    const Periodic_mesh<2> none(std::vector<Coordinates<2>>{}, box, {.merge_duplicates = true});
    CHECK((none.number_of_vertices() == 0 && none.vertex_of_input().empty()));
}

TEST_CASE("Without duplicates, or without the option, point k is vertex k", "[periodic]") {
    Periodic_cases cases(1);
    const Box<3> box = cases.box<3>(7);
    const auto x = cases.points<3>(box, 50);
    for (const bool merge : {false, true}) {
        const Periodic_mesh<3> mesh(x, box, {.merge_duplicates = merge});
        CHECK(cells_of(mesh) == cells_of(Periodic_mesh<3>(x, box)));
        REQUIRE(mesh.vertex_of_input().size() == 50);
        for (Index k = 0; k < 50; ++k) CHECK(mesh.vertex_of_input()[static_cast<std::size_t>(k)] == k);
    }
}
