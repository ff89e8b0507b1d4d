// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes that are a million times and more as long as thick: triangulated, or refused when they are made.
#include <annulus/error.h>
#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <cmath>
#include <memory>
#include <numeric>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
std::unique_ptr<Box<d>> made(const typename Box<d>::Vectors& vectors) {
    try {
        return std::make_unique<Box<d>>(vectors);
    } catch (const Error&) {
        return nullptr;
    }
}

/// The cells are Delaunay, volumes add up, and each volume is that of the pyramids over the facets.
template <int d>
void expect_right(const std::vector<Coordinates<d>>& x, const Box<d>& box) {
    const Periodic_mesh<d> mesh(x, box);
    CHECK(mesh.audit().delaunay());
    const auto volumes = mesh.voronoi_volumes();
    CHECK(std::accumulate(volumes.begin(), volumes.end(), 0.0) == Approx(mesh.box().volume()).epsilon(1e-6));
    const auto list = mesh.neighbours();
    std::vector<double> sum(x.size(), 0);
    for (std::size_t k = 0; k < list.first.size(); ++k)
        sum[static_cast<std::size_t>(list.first[k])] += list.area[k] * list.distance[k] / (2 * d);
    for (std::size_t v = 0; v < x.size(); ++v) CHECK(sum[v] == Approx(volumes[v]).epsilon(1e-6));
}

/// How many boxes, turned by any angle, are accepted; these are triangulated.
template <int d>
int accepted(double thin, std::size_t points, Periodic_cases& cases) {
    int boxes = 0;
    for (const int thin_vectors : {1, d - 1}) {
        CAPTURE(d, std::log10(thin), points, thin_vectors);
        const auto box = made<d>(cases.turned<d>(cases.thin<d>(thin_vectors, thin)));
        if (!box) continue;
        ++boxes;
        const Periodic_mesh<d> mesh(cases.points<d>(*box, points), *box);
        CHECK(mesh.audit().delaunay());
    }
    return boxes;
}

}  // namespace

TEST_CASE("Thin boxes in any direction are triangulated, or refused when they are made", "[kernel][periodic]") {
    Periodic_cases cases(12);
    int near_the_limit = 0;
    for (int k = 0; k < repeats(20); ++k)
        for (const std::size_t points : {1U, 2U, 7U}) {
            for (const double thin : {1e-2, 1e-4, 1e-6}) {
                CHECK(accepted<2>(thin, points, cases) == 2);
                CHECK(accepted<3>(thin, points, cases) == 2);
            }
            const double least = std::pow(10, cases.uniform(-8.5, -7));
            near_the_limit += accepted<2>(least, points, cases) + accepted<3>(least, points, cases);
            CHECK(accepted<2>(1e-9, points, cases) + accepted<3>(1e-9, points, cases) == 0);
        }
    CHECK(near_the_limit > 0);
}

TEST_CASE("Boxes that are thin along an axis are right, however thin, with their facets", "[kernel][periodic]") {
    Periodic_cases cases(13);
    for (const double thin : {1e-3, 1e-9, 1e-12, 1e-15, 1e-30})
        for (const std::size_t points : {1U, 2U, 3U, 12U}) {
            CAPTURE(std::log10(thin), points);
            const Box<2> flat = Box<2>::orthorhombic({1, thin});
            expect_right<2>(cases.points<2>(flat, points, 1), flat);
            const Box<3> wire = Box<3>::orthorhombic({1, thin, thin}), plate = Box<3>::orthorhombic({1, 1, thin});
            expect_right<3>(cases.points<3>(wire, points, 1), wire);
            expect_right<3>(cases.points<3>(plate, points, 1), plate);
        }
}
