// SPDX-License-Identifier: GPL-3.0-or-later
// Neighbours and Voronoi volumes in periodic boxes: crystals, sums, facets that are exactly empty.
#include <annulus/periodic_mesh.h>
#include <annulus/voronoi.h>

#include <support/catch.h>
#include <support/cells_of_periodic.h>
#include <support/crystals.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
using Points = std::vector<Coordinates<d>>;

template <int d>
bool all_are(const std::vector<Index>& counts, Index expected) {
    for (const Index c : counts)
        if (c != expected) return false;
    return true;
}

template <int d>
void expect_sum(const Periodic_mesh<d>& mesh) {
    const auto volumes = mesh.voronoi_volumes();
    for (const double v : volumes) CHECK(v > 0);
    CHECK(std::accumulate(volumes.begin(), volumes.end(), 0.0) ==
          Approx(mesh.box().volume()).epsilon(2 * voronoi_volume_error));
}

/// By a few cells and by one: at rest, carried around the box, and after vibrations.
template <int d>
void expect_neighbours(const Points<d>& basis, Index expected) {
    for (const int k : {1, 2, 3}) {
        CAPTURE(d, k, expected);
        const double a = 1;
        const Points<d> rest = crystal<d>(basis, k, a);
        Periodic_mesh<d> mesh(rest, cube<d>(k * a));
        CHECK(all_are<d>(mesh.neighbour_counts(), expected));
        CHECK(mesh.audit().delaunay());
        expect_sum(mesh);
        const auto cells = cells_of(mesh);
        for (int step = 1; step <= 2 * k; ++step) {
            auto x = rest;
            for (auto& p : x) p[0] += 0.625 * step, p[1] -= 0.375 * step;
            mesh.move_all(x);
            CHECK(all_are<d>(mesh.neighbour_counts(), expected));
        }
        Periodic_cases cases(static_cast<std::uint64_t>(k));
        for (const double s : {1e-12, 1e-6, 1e-4}) {
            auto x = rest;
            for (auto& p : x)
                for (double& c : p) c += cases.uniform(-s, s);
            mesh.move_all(x);
            CHECK(mesh.audit().delaunay());
            // Facets that were empty have an area of the order of s, or of s^2 where they were points.
            CHECK(all_are<d>(mesh.neighbour_counts(50 * s), expected));
            expect_sum(mesh);
        }
        mesh.move_all(rest);
        CHECK(cells_of(mesh) == cells);
    }
}

}  // namespace

TEST_CASE("Crystals have the neighbours that have a facet in common, at rest, drifted and vibrated",
          "[measure][periodic]") {
    expect_neighbours<3>(sc, 6);
    expect_neighbours<3>(bcc, 14);
    expect_neighbours<3>(fcc, 12);
    expect_neighbours<3>(diamond, 16);
    expect_neighbours<2>({{0, 0}}, 4);
    expect_neighbours<2>({{0, 0}, {.5, .5}}, 4);
}

TEST_CASE("Crystals whose lattice constant is no binary fraction have these neighbours by area",
          "[measure][periodic]") {
    const Periodic_mesh<3> copper(crystal<3>(fcc, 3, 3.615), cube<3>(3 * 3.615));
    CHECK(all_are<3>(copper.neighbour_counts(1e-9), 12));
    const Periodic_mesh<3> silicon(crystal<3>(diamond, 2, 5.431), cube<3>(2 * 5.431));
    CHECK(all_are<3>(silicon.neighbour_counts(1e-9), 16));
    // A hexagonal lattice: one point in a rhombus, two in a rectangle.
    const Periodic_mesh<2> one(Points<2>{{0.25, 0.5}}, Box<2>({{{1, 0}, {0.5, std::sqrt(0.75)}}}));
    CHECK(all_are<2>(one.neighbour_counts(), 6));
    const Periodic_mesh<2> two(Points<2>{{0, 0}, {0.5, std::sqrt(0.75)}}, Box<2>::orthorhombic({1, std::sqrt(3.0)}));
    CHECK(all_are<2>(two.neighbour_counts(1e-9), 6));
}

TEST_CASE("A point alone in a cube is its own neighbour six times, with facets of area 1", "[measure][periodic]") {
    const Periodic_mesh<3> mesh(Points<3>{{0.5, 0.25, 0.125}}, cube<3>(1));
    const auto list = mesh.neighbours();
    CHECK(list.first.size() == 14);
    int whole = 0;
    for (std::size_t k = 0; k < list.first.size(); ++k) {
        CHECK((list.area[k] == 0 || list.area[k] == Approx(1)));
        if (list.area[k] == 0) continue;
        ++whole;
        CHECK(list.distance[k] == 1);
    }
    CHECK(whole == 6);
    CHECK(mesh.neighbour_counts() == std::vector<Index>{6});
    CHECK(mesh.neighbour_counts(0, false) == std::vector<Index>{14});
    CHECK(mesh.voronoi_volumes()[0] == Approx(1).epsilon(voronoi_volume_error));
}

TEST_CASE("Volumes and areas agree, and scale with the box", "[measure][periodic]") {
    for (const double unit : {1.0, 0x1p100, 0x1p-100}) {
        Periodic_cases cases(3);
        for (int kind = 0; kind < Periodic_cases::kinds; ++kind) {
            CAPTURE(unit, kind);
            auto vectors = cases.box<3>(kind).vectors();
            auto x = cases.points<3>(Box<3>(vectors), 30);
            for (auto& v : vectors)
                for (double& c : v) c *= unit;
            for (auto& p : x)
                for (double& c : p) c *= unit;
            const Periodic_mesh<3> mesh(x, Box<3>(vectors));
            expect_sum(mesh);
            // A Voronoi cell is a union of pyramids over its facets.
            const auto volumes = mesh.voronoi_volumes();
            const auto list = mesh.neighbours();
            std::vector<double> sum(x.size(), 0);
            for (std::size_t k = 0; k < list.first.size(); ++k)
                sum[static_cast<std::size_t>(list.first[k])] += list.area[k] * list.distance[k] / 6;
            for (std::size_t v = 0; v < x.size(); ++v) CHECK(sum[v] == Approx(volumes[v]).epsilon(1e-9));
        }
    }
}

TEST_CASE("Areas of neighbours are those of the Voronoi diagram, however small", "[measure][periodic]") {
    Periodic_cases cases(9);
    for (const double noise : {1e-14, 1e-12, 1e-9}) {
        CAPTURE(noise);
        auto x = crystal<3>(sc, 3, 1);
        for (auto& p : x)
            for (double& c : p) c += cases.uniform(-noise, noise);
        const Periodic_mesh<3> mesh(x, cube<3>(3));
        const auto diagram = mesh.voronoi();
        std::map<std::tuple<Index, Index, Shift<3>>, double> measures;
        for (std::size_t k = 0; k < diagram.pair.size(); ++k)
            measures[{diagram.pair[k][0], diagram.pair[k][1], diagram.shift[k]}] = diagram.measure[k];
        const auto list = mesh.neighbours();
        std::size_t found = 0, small = 0;
        for (std::size_t k = 0; k < list.first.size(); ++k) {
            const auto it = measures.find({list.first[k], list.second[k], list.shift[k]});
            if (it == measures.end()) continue;  // listed the other way round
            ++found;
            small += it->second > 0 && it->second < 0.1 ? 1 : 0;
            CHECK(std::fabs(list.area[k] - it->second) <= 2 * voronoi_diagram_error * it->second);
        }
        CHECK(found == diagram.pair.size());
        CHECK(small > 20);
    }
}

TEST_CASE("Points on a lattice that is nearly degenerate have exact volumes", "[measure][periodic]") {
    Periodic_cases cases(8);
    auto x = crystal<3>(fcc, 2, 1);
    for (auto& p : x)
        for (double& c : p) c += cases.uniform(-1e-14, 1e-14);
    const Periodic_mesh<3> mesh(x, cube<3>(2));
    for (const double v : mesh.voronoi_volumes()) CHECK(v == Approx(0.25).epsilon(1e-9));
    expect_sum(mesh);
}
