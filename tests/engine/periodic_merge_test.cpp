// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic_options::merge_duplicates: points that are images of one another are one vertex.
#include <annulus/error.h>
#include <annulus/periodic_mesh.h>
#include <annulus/space/for_each_shift.h>

#include <support/catch.h>
#include <support/cells_of_periodic.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
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

/// Boxes of random directions, thin in one of them, and points in the other ones with their images.
template <int d>
void expect_merged_at_border() {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        CAPTURE(d, seed);
        Periodic_cases cases(seed);
        typename Box<d>::Vectors v;
        for (auto& vector : v)
            for (double& c : vector) c = cases.uniform(-1, 1);
        for (std::size_t j = 0; j < d; ++j) {  // made orthonormal
            for (std::size_t k = 0; k < j; ++k) {
                const double along = std::inner_product(v[j].begin(), v[j].end(), v[k].begin(), 0.0);
                for (std::size_t i = 0; i < d; ++i) v[j][i] -= along * v[k][i];
            }
            const double length = std::sqrt(std::inner_product(v[j].begin(), v[j].end(), v[j].begin(), 0.0));
            for (double& c : v[j]) c /= length;
        }
        for (double& c : v[d - 1]) c *= std::ldexp(1.0, -static_cast<int>(10 + seed % 17));
        try {
            v = Periodic_mesh<d>(std::vector<Coordinates<d>>{}, Box<d>(v)).box().vectors();
        } catch (const Error& e) {
            CHECK(e.code() == Error_code::usage);  // too thin
            continue;
        }
        for (int k = 0; k < 20; ++k) {
            Coordinates<d> p{};
            for (std::size_t j = 0; j + 1 < d; ++j)
                for (std::size_t i = 0, c = cases.below(64); i < d; ++i) p[i] += static_cast<double>(c) / 64 * v[j][i];
            const Coordinates<d> place = Periodic_mesh<d>(std::vector{p}, Box<d>(v)).saved().places[0];
            std::vector<Coordinates<d>> x;
            for_each_shift<d>(1, [&](const Shift<d>& s) {
                x.push_back(place);
                for (std::size_t j = 0; j < d; ++j)
                    for (std::size_t i = 0; i < d; ++i) x.back()[i] += s[j] * v[j][i];
            });
            REQUIRE(Periodic_mesh<d>(x, Box<d>(v), {.merge_duplicates = true}).number_of_vertices() == 1);
        }
    }
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
    for (const double a : {1.0, 49.0}) {  // 49 times the double nearest to 1 / 49 is less than 1
        CAPTURE(a);
        const std::vector<Coordinates<2>> x{{0, 0},         {-1e-30, 0},     {a, a},
                                            {a / 2, a / 2}, {3 * a, -1e-30}, {a / 2, -a / 2}};
        const auto box = Box<2>::orthorhombic({a, a});
        const Periodic_mesh<2> mesh(x, box, {.merge_duplicates = true});
        CHECK(mesh.number_of_vertices() == 2);
        const std::vector<Index> of{0, 0, 0, 1, 0, 1};
        CHECK(std::equal(of.begin(), of.end(), mesh.vertex_of_input().begin(), mesh.vertex_of_input().end()));
        const Periodic_mesh<2> none(std::vector<Coordinates<2>>{}, box, {.merge_duplicates = true});
        CHECK((none.number_of_vertices() == 0 && none.vertex_of_input().empty()));
    }
}

TEST_CASE("In a box as thin as there are any, images at its border are one vertex on request", "[periodic]") {
    const Box<3> thin({{{-0.798193956802562, -0.5133536225305804, -0.315205433897642},
                        {-0.0515243994759107, -0.46315230836272825, 0.8847797327679494},
                        {-8.621562486155199e-08, 1.0377979897668865e-07, 4.9304524907256564e-08}}});
    const std::vector<Coordinates<3>> x{{-0.7750102674868078, -0.8375800439955405, 0.407790041298572},
                                        {.1, .2, .3},
                                        {-0.7750103537024327, -0.8375799402157416, 0.4077900906030969}};
    const Periodic_mesh<3> mesh(x, thin, {.merge_duplicates = true});
    CHECK((mesh.number_of_vertices() == 2 && mesh.vertex_of_input()[2] == 0));
    expect_merged_at_border<2>();
    expect_merged_at_border<3>();
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
