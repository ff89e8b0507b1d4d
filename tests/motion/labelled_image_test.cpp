// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes.h"

#include <annulus/error.h>
#include <apps/motion/labelled_image.h>

#include <support/catch.h>

#include <cmath>
#include <numbers>

using namespace annulus;
using namespace annulus_test;

namespace {

/// Voxels whose centre satisfies f.
template <class F>
Labelled_image image_of(const std::array<std::size_t, 3>& size, const Coordinates<3>& spacing, F f) {
    Labelled_image image{size, spacing, {}};
    for (std::size_t k = 0; k < size[2]; ++k)
        for (std::size_t j = 0; j < size[1]; ++j)
            for (std::size_t i = 0; i < size[0]; ++i)
                image.label.push_back(f(static_cast<double>(i) * spacing[0], static_cast<double>(j) * spacing[1],
                                        static_cast<double>(k) * spacing[2])
                                          ? 3
                                          : 0);
    return image;
}

}  // namespace

TEST_CASE("the surface of a voxel ball is closed, and encloses the ball", "[motion][image]") {
    const std::size_t most = GENERATE(std::size_t{128}, std::size_t{32});
    const auto image = image_of({50, 40, 60}, {0.5, 0.6, 0.4},
                                [](double x, double y, double z) { return std::hypot(x - 12, y - 12, z - 12) < 9; });
    const Triangle_surface s = surface_of(image, most);
    CHECK(closed(s));
    CHECK(enclosed_volume(s) == Approx(4 * std::numbers::pi / 3 * 729).epsilon(0.02));
    // A sphere: V - E + F = 2.
    CHECK(2 * s.points.size() == s.triangles.size() + 4);
    for (const auto& p : s.points) CHECK(std::abs(std::hypot(p[0] - 12, p[1] - 12, p[2] - 12) - 9) < 0.7);
}

TEST_CASE("random voxels have a closed surface that separates them", "[motion][image]") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        std::mt19937 bits(seed);
        const auto image = image_of({7, 5, 6}, {1, 1, 1}, [&](double, double, double) { return bits() % 3 == 0; });
        const Triangle_surface s = surface_of(image);
        REQUIRE(closed(s));
        for (std::size_t k = 0; k < 6; ++k)
            for (std::size_t j = 0; j < 5; ++j)
                for (std::size_t i = 0; i < 7; ++i) {
                    const Coordinates<3> centre{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
                    CHECK(winding(s, centre) == Approx(image.at(i, j, k) != 0 ? 1 : 0).margin(1e-9));
                }
    }
}

TEST_CASE("what touches the border of the image is closed there", "[motion][image]") {
    const auto image = image_of({4, 4, 4}, {1, 1, 2}, [](double, double, double) { return true; });
    const Triangle_surface s = surface_of(image);
    CHECK(closed(s));
    CHECK(enclosed_volume(s) > 0.7 * 128);
    CHECK(enclosed_volume(s) < 128);
}

TEST_CASE("an image without labels is refused", "[motion][image]") {
    CHECK_THROWS_AS(surface_of(image_of({3, 3, 3}, {1, 1, 1}, [](double, double, double) { return false; })), Error);
    CHECK_THROWS_AS(surface_of(Labelled_image{{2, 2, 2}, {1, 1, 1}, {1}}), Error);
}
