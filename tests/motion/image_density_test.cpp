// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours_of.h"
#include "oracle.h"

#include <annulus/error.h>
#include <apps/motion/domain_2.h>
#include <apps/motion/image_density.h>
#include <apps/motion/lloyd_2.h>
#include <apps/motion/moments_2.h>
#include <apps/motion/sampling_2.h>
#include <apps/motion/stippling.h>

#include <support/catch.h>
#include <support/repeats.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

using namespace annulus;

namespace {

using Points = std::vector<Coordinates<2>>;

struct Pixels {
    std::size_t width, height;
    std::vector<std::uint32_t> weight;  ///< from the top
    [[nodiscard]] Image_density density() const { return {width, height, weight}; }
    /// The weight of the pixel nearest to column i, row j from below.
    [[nodiscard]] oracle::Real at(long i, long j) const {
        const long c = std::clamp(i, 0L, static_cast<long>(width) - 1),
                   r = std::clamp(j, 0L, static_cast<long>(height) - 1);
        return weight[(height - 1 - static_cast<std::size_t>(r)) * width + static_cast<std::size_t>(c)];
    }
    /// Bilinear interpolation between the middles of pixels, by its definition.
    [[nodiscard]] oracle::Real at(oracle::Real x, oracle::Real y) const {
        const oracle::Real u = std::floor(x - 0.5L), v = std::floor(y - 0.5L), s = x - 0.5L - u, t = y - 0.5L - v;
        const long i = static_cast<long>(u), j = static_cast<long>(v);
        return (1 - t) * ((1 - s) * at(i, j) + s * at(i + 1, j)) + t * ((1 - s) * at(i, j + 1) + s * at(i + 1, j + 1));
    }
};

template <class Random>
Pixels random_pixels(Random& random, std::size_t width, std::size_t height, std::uint32_t most) {
    Pixels p{width, height, {}};
    for (std::size_t i = 0; i < width * height; ++i)
        p.weight.push_back(static_cast<std::uint32_t>(random() % (most + std::uint64_t{1})));
    p.weight[random() % p.weight.size()] = most;
    return p;
}

/// The part of a polygon where coordinate k is at least `bound` (sign 1) or at most (sign -1).
std::vector<oracle::Point> cut(const std::vector<oracle::Point>& polygon, int k, oracle::Real sign,
                               oracle::Real bound) {
    std::vector<oracle::Point> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const oracle::Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const oracle::Real p = sign * ((k ? a.y : a.x) - bound), q = sign * ((k ? b.y : b.x) - bound);
        if (p >= 0) kept.push_back(a);
        if ((p >= 0) != (q >= 0)) kept.push_back({a.x + p / (p - q) * (b.x - a.x), a.y + p / (p - q) * (b.y - a.y)});
    }
    return kept;
}

/// Square by square between the middles of pixels, where the density is one polynomial.
oracle::Moments exact_moments(const Pixels& pixels, Coordinates<2> c, const Points& offsets) {
    oracle::Moments sum;
    std::vector<oracle::Point> polygon;
    oracle::Real low[2] = {1e9L, 1e9L}, high[2] = {-1e9L, -1e9L};
    for (const auto& u : offsets) {
        polygon.push_back({u[0] + oracle::Real(c[0]), u[1] + oracle::Real(c[1])});
        low[0] = std::min(low[0], polygon.back().x), low[1] = std::min(low[1], polygon.back().y);
        high[0] = std::max(high[0], polygon.back().x), high[1] = std::max(high[1], polygon.back().y);
    }
    for (oracle::Real x = std::floor(low[0] - 0.5L) + 0.5L; x < high[0]; ++x)
        for (oracle::Real y = std::floor(low[1] - 0.5L) + 0.5L; y < high[1]; ++y) {
            auto part = cut(cut(cut(cut(polygon, 0, 1, x), 0, -1, x + 1), 1, 1, y), 1, -1, y + 1);
            for (auto& p : part) p = {p.x - c[0], p.y - c[1]};
            for (std::size_t k = 1; k + 1 < part.size(); ++k)
                oracle::add_triangle(
                    sum, [&](oracle::Real a, oracle::Real b) { return pixels.at(a, b); }, {c[0], c[1]}, part[0],
                    part[k], part[k + 1], 1e9L);
        }
    return sum;
}

}  // namespace

TEST_CASE("moments under an image are those of its squares, one by one", "[motion][image]") {
    const std::uint64_t seed = GENERATE(1u, 2u, 3u);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    double worst = 0;
    for (const double h : {1e-3, 0.1, 0.4, 1.0, 3.0, 11.0})
        for (int i = 0; i < repeats(30); ++i) {
            const auto pixels =
                random_pixels(random, 1 + random() % 60, 1 + random() % 40, i % 3 ? 255 : Image_density::most_weight);
            const auto w = static_cast<double>(pixels.width), t = static_cast<double>(pixels.height);
            Coordinates<2> c{w * unit(random), t * unit(random)};
            if (i % 5 == 0)
                c = {std::floor(c[0]) + 0.5, std::floor(c[1]) + (i % 2 ? 0.5 : 0.0)};  // on the lines of the lattice
            Points offsets = oracle::random_polygon(random, h);
            if (i % 7 == 0) offsets = {{-h, -h}, {h, -h}, {h, h}, {-h, h}};
            // Cut to the image, as cells are.
            std::vector<oracle::Point> inside;
            for (const auto& u : offsets) inside.push_back({c[0] + oracle::Real(u[0]), c[1] + oracle::Real(u[1])});
            inside = cut(cut(cut(cut(inside, 0, 1, 0), 0, -1, w), 1, 1, 0), 1, -1, t);
            offsets.clear();
            for (const auto& p : inside)
                offsets.push_back({static_cast<double>(p.x - c[0]), static_cast<double>(p.y - c[1])});
            const auto exact = exact_moments(pixels, c, offsets);
            if (exact.mass < 1e-3L * h * h) continue;  // white
            const Moments_2 got = moments(Density_2(pixels.density()), c, oracle::straight(offsets));
            CAPTURE(seed, h, i, pixels.width, pixels.height, c[0], c[1]);
            const double size = std::min(h, std::hypot(w, t));
            const double e = static_cast<double>(
                std::max(std::abs(got.mass / exact.mass - 1),
                         std::hypot(got.first[0] - exact.x, got.first[1] - exact.y) / (exact.mass * size)));
            worst = std::max(worst, e * std::min(1.0, h));
            CHECK(e * std::min(1.0, h) < 1e-12);
        }
    std::printf("images: seed %d, worst error %.1e\n", static_cast<int>(seed), worst);
}

TEST_CASE("an image weighs what its pixels weigh", "[motion][image]") {
    std::mt19937_64 random(9);
    const auto pixels = random_pixels(random, 300, 200, 1000);
    const Image_density density = pixels.density();
    const Domain_2 rectangle = Domain_2::polygon(Points{{0, 0}, {300, 0}, {300, 200}, {0, 200}});
    const Cell_2 all = rectangle.whole({120.3, 77.7});
    CHECK(moments(Density_2(density), all.origin, all.corners).mass ==
          Approx(static_cast<double>(density.total())).epsilon(1e-12));
    for (int i = 0; i < 300; ++i) {
        const double x = 300e-3 * static_cast<double>(random() % 1001),
                     y = 200e-3 * static_cast<double>(random() % 1001);
        REQUIRE(density.at({x, y}) ==
                Approx(static_cast<double>(pixels.at(oracle::Real(x), oracle::Real(y)))).epsilon(1e-12).margin(1e-9));
    }
}

TEST_CASE("where an image has no weight a cell has no moments", "[motion][image]") {
    // Ink in the rows of a leaning cell, between it and the column of its origin, which counts on both sides of the
    // cell.
    std::mt19937_64 random(11);
    Pixels pixels{40, 20, std::vector<std::uint32_t>(800, 0)};
    for (std::size_t j = 2; j < 6; ++j)
        for (std::size_t i = 18; i < 21; ++i)
            pixels.weight[40 * j + i] = static_cast<std::uint32_t>(random() % Image_density::most_weight);
    const std::vector<Corner_2> corners = oracle::straight({{-8.1, -6}, {-5, -6.3}, {10.2, 8}, {7.9, 8.4}});
    for (int i = 0; i < 20; ++i) {
        const Moments_2 got = moments(Density_2(pixels.density()), {20.3 + 0.01 * i, 9.1}, corners);
        CHECK(got.mass == 0);
        CHECK(got.first[0] == 0);
        CHECK(got.first[1] == 0);
    }
}

TEST_CASE("images that cannot be and domains that do not fit are refused", "[motion][image]") {
    const std::vector<std::uint32_t> white(6, 0), six(6, 1), much(6, 1u << 24);
    CHECK_THROWS_AS(Image_density(2, 3, white), Error);
    CHECK_THROWS_AS(Image_density(2, 2, six), Error);
    CHECK_THROWS_AS(Image_density(0, 0, {}), Error);
    CHECK_THROWS_AS(Image_density(2, 3, much), Error);
    const Density_2 density = Image_density(2, 3, six);
    CHECK_THROWS_AS(Lloyd_2(Domain_2::disc(1), density), Error);
    CHECK_THROWS_AS(Lloyd_2(Domain_2::polygon(Points{{0, 0}, {2.1, 0}, {1, 1}}), density), Error);
    CHECK_THROWS_AS(sample(Domain_2::square(1), density, 3, 1), Error);
    CHECK_NOTHROW(Lloyd_2(Domain_2::polygon(Points{{0, 0}, {2, 0}, {2, 3}}), density));
    CHECK_THROWS_AS(Stippling({2, 1, 255, {255, 255}}, false), Error);
    CHECK_THROWS_AS(Stippling({2, 1, 255, {0, 0}}, true), Error);
    CHECK_THROWS_AS(Stippling({2, 1, 255, {0}}, false), Error);
    CHECK_THROWS_AS(Stippling({2, 1, 100, {0, 101}}, false), Error);
}

TEST_CASE("points are drawn from an image in proportion to its density", "[motion][image]") {
    const Pixels pixels{4, 3, {0, 7, 1, 9, 20, 0, 3, 0, 5, 5, 40, 10}};
    const Domain_2 rectangle = Domain_2::polygon(Points{{0, 0}, {4, 0}, {4, 3}, {0, 3}});
    const int n = 200'000, fine = 4;
    const Points drawn = sample(rectangle, pixels.density(), static_cast<std::size_t>(n), 3);
    std::vector<double> seen(16 * 12);
    for (const auto& p : drawn) {
        REQUIRE(rectangle.contains(p));
        seen[std::min(static_cast<std::size_t>(p[1] * fine), std::size_t{11}) * 16 +
             std::min(static_cast<std::size_t>(p[0] * fine), std::size_t{15})] += 1;
    }
    double chi = 0;
    for (std::size_t j = 0; j < 12; ++j)
        for (std::size_t i = 0; i < 16; ++i) {
            const double x = static_cast<double>(i) / fine, y = static_cast<double>(j) / fine, d = 1.0 / fine;
            const auto share = exact_moments(pixels, {x, y}, {{0, 0}, {d, 0}, {d, d}, {0, d}}).mass / 100;
            const double expected = n * static_cast<double>(share);
            if (expected == 0) CHECK(seen[j * 16 + i] == 0);
            else chi += (seen[j * 16 + i] - expected) * (seen[j * 16 + i] - expected) / expected;
        }
    std::printf("drawn from an image: chi square %.0f of 192 boxes\n", chi);
    CHECK(chi < 192 + 5 * std::sqrt(2.0 * 192));
}

TEST_CASE("a stippled gradient has as many points in a band as ink, and keeps them", "[motion][image]") {
    const bool inverted = GENERATE(false, true);
    Gray_image image{200, 60, 4000, {}};
    for (std::size_t j = 0; j < image.height; ++j)
        for (std::size_t i = 0; i < image.width; ++i) image.value.push_back(static_cast<std::uint16_t>(20 * i));
    const Stippling stippling(image, inverted);
    const Domain_2 rectangle = Domain_2::polygon(Points{{0, 0}, {200, 0}, {200, 60}, {0, 60}});
    Points points = sample(rectangle, stippling.ink(), 2000, 5), target(points.size());
    const Lloyd_2 lloyd(rectangle, stippling.density(), 2);
    for (int i = 0; i < 150; ++i) {
        CHECK(lloyd.step(neighbours_of(points), points, target).kept == 0);
        points = target;
    }
    int band[5] = {};
    for (const auto& p : points) {
        REQUIRE(rectangle.contains(p));
        ++band[std::min(static_cast<int>(p[0] / 40), 4)];
    }
    for (int k = 0; k < 5; ++k) {
        const int at = inverted ? k : 4 - k;
        CAPTURE(inverted, k, band[at]);
        // The share of ink is (2k + 1) / 25. One row of points is 20 of them.
        CHECK(std::abs(band[at] - 2000 * (2 * k + 1) / 25) < 30);
    }
}

TEST_CASE("squares of ink lose nothing of pictures of 8 bits, and little of those of 16", "[motion][image]") {
    Gray_image eight{256, 1, 255, {}}, sixteen{256, 256, 65535, {}};
    for (unsigned i = 0; i < 256; ++i) eight.value.push_back(static_cast<std::uint16_t>(255 - i));
    for (unsigned i = 0; i < 65536; ++i) sixteen.value.push_back(static_cast<std::uint16_t>(65535 - i));
    const Image_density a = Stippling(eight, false).density(), b = Stippling(sixteen, false).density();
    for (std::int64_t i = 0; i < 256; ++i) REQUIRE(a.node(static_cast<std::size_t>(i) + 1, 1).weight == i * i);
    for (std::int64_t i = 0; i < 65536; ++i) {
        const auto got = b.node(static_cast<std::size_t>(i % 256) + 1, 256 - static_cast<std::size_t>(i / 256)).weight;
        REQUIRE(got >= std::min<std::int64_t>(i * i / 256, Image_density::most_weight));
        REQUIRE(got <= i * i / 256 + 1);
        REQUIRE((got == 0) == (i == 0));
    }
}

TEST_CASE("an image that is laid over a rectangle is stretched", "[motion][image]") {
    // Density 1 to the left and 3 to the right, around pixels of 2 by 0.5; the rectangle is [-1, 7] x [2, 2.5].
    const Image_density image(4, 1, std::vector<std::uint32_t>{1, 1, 3, 3});
    const Density_2 density = Placed_image{image, {-1, 2}, {2, 0.5}};
    CHECK(density_at(density, {0, 2.25}) == 1);
    CHECK(density_at(density, {3, 2.1}) == 2);
    CHECK(density_at(density, {6.5, 2.4}) == 3);
    const Domain_2 rectangle = Domain_2::polygon(Points{{-1, 2}, {7, 2}, {7, 2.5}, {-1, 2.5}});
    const Cell_2 whole = rectangle.whole({1, 2.25});
    const Moments_2 m = moments(density, whole.origin, whole.corners);
    // Along x: 1 up to 2, then from 1 to 3 up to 4, then 3.
    CHECK(m.mass == Approx(0.5 * (3 + 4 + 9)).epsilon(1e-14));
    CHECK(m.first[0] == Approx(0.5 * (3 * 0.5 + 2 * (2 * 3 + 1.0 / 3) + 9 * 5.5) - m.mass).epsilon(1e-14));
    CHECK(std::abs(m.first[1]) < 1e-14);
    std::size_t right = 0;
    for (const auto& p : sample(rectangle, density, 4000, 1)) {
        CHECK(rectangle.contains(p));
        right += p[0] > 3;
    }
    CHECK(std::abs(static_cast<double>(right) / 4000 - 11.5 / 16) < 0.03);
    CHECK_THROWS_AS(Lloyd_2(Domain_2::disc(1), density), Error);
}
