// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours_of.h"

#include <annulus/error.h>
#include <apps/motion/lloyd_2.h>
#include <apps/motion/region_2.h>
#include <apps/motion/region_cell_2.h>
#include <apps/motion/sampling_2.h>

#include <support/catch.h>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <vector>

using namespace annulus;

namespace {

using Points = std::vector<Coordinates<2>>;
using Rings = std::vector<Points>;

Region_2 region_of(const Rings& rings) {
    Points corners;
    std::vector<std::size_t> begin;
    for (const Points& ring : rings) {
        begin.push_back(corners.size());
        corners.insert(corners.end(), ring.begin(), ring.end());
    }
    return Region_2::polygon(corners, begin);
}

/// An L with a square hole, in which there is a triangle.
const Rings l_with_hole{{{0, 0}, {4, 0}, {4, 1.5}, {1.5, 1.5}, {1.5, 4}, {0, 4}},
                        {{0.25, 0.25}, {1.25, 0.25}, {1.25, 1.25}, {0.25, 1.25}},
                        {{0.5, 0.5}, {1, 0.5}, {0.75, 1}}};

struct Exact {
    mpq_class x, y;
};

/// Mass and first moments of the part of the region that is nearer to site v than to all others, in rational numbers: a
/// ring cut by a line, doubled edges and all, has by Green's theorem the integrals of its part.
std::array<mpq_class, 3> exact_moments(const Rings& rings, const Points& sites, std::size_t v) {
    std::array<mpq_class, 3> sum{0, 0, 0};
    for (std::size_t r = 0; r < rings.size(); ++r) {
        std::vector<Exact> ring;
        for (const auto& p : rings[r]) ring.push_back({p[0], p[1]});
        mpq_class all = 0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Exact &a = ring[i], &b = ring[(i + 1) % ring.size()];
            all += a.x * b.y - a.y * b.x;
        }
        // Each ring is in the one before: the first counts, the second does not, the third does.
        if ((all > 0) != (r % 2 == 0)) std::reverse(ring.begin(), ring.end());
        for (std::size_t u = 0; u < sites.size(); ++u) {
            if (u == v) continue;
            const mpq_class sx = sites[v][0], sy = sites[v][1], tx = sites[u][0], ty = sites[u][1];
            const auto height = [&](const Exact& p) -> mpq_class {
                return 2 * p.x * (tx - sx) + 2 * p.y * (ty - sy) - (tx * tx + ty * ty - sx * sx - sy * sy);
            };
            std::vector<Exact> next;
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Exact &a = ring[i], &b = ring[(i + 1) % ring.size()];
                const mpq_class h = height(a), k = height(b);
                if (h <= 0) next.push_back(a);
                if ((h > 0) == (k > 0)) continue;
                const mpq_class t = h / (h - k);
                next.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
            }
            ring = next;
        }
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Exact &a = ring[i], &b = ring[(i + 1) % ring.size()];
            const mpq_class w = a.x * b.y - a.y * b.x;
            sum[0] += w / 2;
            sum[1] += w * (a.x + b.x) / 6;
            sum[2] += w * (a.y + b.y) / 6;
        }
    }
    return sum;
}

std::string refusal(const Rings& rings) {
    try {
        (void)region_of(rings);
    } catch (const Error& error) {
        CHECK(error.code() == Error_code::bad_input);
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("a region has the area of its rings, whatever their order and directions", "[motion][region]") {
    const Region_2 region = region_of(l_with_hole);
    CHECK_FALSE(region.convex());
    CHECK(region.area() == Approx(9.75 - 1 + 0.125).epsilon(1e-14));
    const auto same = [&](const Rings& rings) {
        const Region_2 other = region_of(rings);
        return std::ranges::equal(other.triangles().all(), region.triangles().all(), {}, &Triangle_2::corner,
                                  &Triangle_2::corner);
    };
    Rings rings = l_with_hole;
    std::reverse(rings.begin(), rings.end());
    CHECK(same(rings));
    std::reverse(rings[1].begin(), rings[1].end());
    rings[1].push_back(rings[1].front());
    std::rotate(rings[0].begin(), rings[0].begin() + 1, rings[0].end());
    CHECK(same(rings));
    CHECK(region_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}}).convex());
    CHECK(region_of({{{0, 0}, {1, 0}, {1, 1}}, {{2, 0}, {3, 0}, {2, 1}}}).area() == Approx(1));  // two pieces
    CHECK(region_of({{{0, 0}, {2, 0}, {1, 0.5}, {1, 2}}}).area() == Approx(1.25));               // a notch
}

TEST_CASE("a region contains what an odd number of rings encloses", "[motion][region]") {
    const Region_2 region = region_of(l_with_hole);
    for (const auto& p : Points{{0.1, 0.1}, {3, 1}, {0.75, 0.75}, {4, 1.5}, {1.5, 2}, {0.25, 0.5}, {1.5 + 1e-15, 2}})
        CHECK(region.contains(p));
    for (const auto& p : Points{{0.3, 0.3}, {1, 1}, {2, 2}, {5, 1}, {-0.1, 1}, {1.5 + 1e-12, 2}})
        CHECK_FALSE(region.contains(p));
    std::set<Coordinates<2>> different;
    for (const auto& p : sample(region, Density::one, 500, 3)) {
        CHECK(region.contains(p));
        different.insert(p);
    }
    CHECK(different.size() == 500);
}

TEST_CASE("rings that meet are refused with the corners of their edges", "[motion][region]") {
    const auto refused = [](const Rings& rings, const std::string& words) {
        const std::string said = refusal(rings);
        CAPTURE(said);
        return said.find(words) != std::string::npos;
    };
    CHECK(refused({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}, "corners 0 and 2"));                            // a bow
    CHECK(refused({{{0, 0}, {2, 0}, {1, 0}, {1, 1}}}, "corners 0 and 1"));                            // a spike
    CHECK(refused({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}, "corners 0 and 2"));                    // touches an edge
    CHECK(refused({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {5, 1}, {1, 2}}}, "corners 1 and 4"));  // a hole juts out
    CHECK(refused({{{0, 0}, {4, 0}, {4, 4}}, {{0, 0}, {4, 0}, {4, 4}}}, "corners 0 and 3"));          // twice the same
    CHECK(refused({{{0, 0}, {4, 0}, {4, 4}}, {{3, 1}, {3, 1}}}, "all its 2 are at one place"));
    CHECK(refused({{{0, 0}, {4, 0}, {4, 4}}, {}}, "different ones here: 0"));
    CHECK(refused({{{0, 0}, {1e101, 0}, {1, 1}, {3, 4}}}, "between 1e-100 and 1e100"));
    CHECK(refusal({{{0, 0}, {4, 0}, {4, 4}}, {{2, 0.5}, {3, 0.5}, {3, 1}}}).empty());
}

TEST_CASE("centroids in a region are those of rational arithmetic", "[motion][region][lloyd]") {
    const Region_2 region = region_of(l_with_hole);
    std::size_t moved_to_the_border = 0;
    for (const std::size_t n : {std::size_t{3}, std::size_t{7}, std::size_t{40}, std::size_t{300}}) {
        CAPTURE(n);
        const Points points = sample(region, Density::one, n, n);
        Points target(n), again(n);
        const Lloyd_2 lloyd(region, Density::one);
        CHECK(lloyd.step(neighbours_of(points), points, target).kept == 0);
        (void)Lloyd_2(region, Density::one, 2).step(neighbours_of(points), points, again);
        CHECK(again == target);
        mpq_class area = 0;
        for (std::size_t v = 0; v<n; v += n> 100 ? 9 : 1) {
            const auto m = exact_moments(l_with_hole, points, v);
            area += m[0];
            const Coordinates<2> centroid{mpq_class(m[1] / m[0]).get_d(), mpq_class(m[2] / m[0]).get_d()};
            CAPTURE(v, centroid[0], centroid[1]);
            CHECK(region.contains(target[v]));
            if (region.contains(centroid)) {
                CHECK(std::hypot(target[v][0] - centroid[0], target[v][1] - centroid[1]) < 1e-13);
                continue;
            }
            ++moved_to_the_border;
            // Nearer to the centroid than the site; and still nearest to that site.
            CHECK(std::hypot(target[v][0] - centroid[0], target[v][1] - centroid[1]) <
                  std::hypot(points[v][0] - centroid[0], points[v][1] - centroid[1]));
            for (std::size_t u = 0; u < n; ++u)
                CHECK(std::hypot(target[v][0] - points[v][0], target[v][1] - points[v][1]) <=
                      std::hypot(target[v][0] - points[u][0], target[v][1] - points[u][1]));
        }
        if (n <= 100) CHECK(area == mpq_class(71, 8));  // the oracle's cells fill the region
    }
    CHECK(moved_to_the_border > 0);
}

TEST_CASE("a centroid outside of a region becomes the nearest point of the cell", "[motion][region][lloyd]") {
    // One site: its cell is a square ring, whose centroid is the middle of the hole.
    const Region_2 ring = region_of({{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}});
    const Points site{{1.5, 1.5}};
    Points target(1);
    CHECK(Lloyd_2(ring, Density::one).step(neighbours_of(site), site, target).kept == 0);
    CHECK(ring.contains(target[0]));
    CHECK(std::hypot(target[0][0], target[0][1]) == Approx(1).margin(2e-3));
}

TEST_CASE("moments under every density add up over the parts of a cell", "[motion][region]") {
    const Region_2 region = region_of(l_with_hole);
    const Cell_2 hull = region.hull().whole({1, 1});
    Region_cell_2 parts_of(region);
    const std::vector<std::uint32_t> pixels(20, 7);
    for (const Density_2& density : {Density_2(Density::one), Density_2(Density::x2), Density_2(Density::x2_plus_y2),
                                     Density_2(Smooth_density{[](const Coordinates<2>& p) { return p[0]; }, 4, 1, 1}),
                                     Density_2(Image_density(4, 5, pixels))}) {
        const Moments_2 all = moments(density, hull.origin, parts_of(hull));
        // Of the three rings, outside those of the hull: L, hole and triangle, each cut from its own hull.
        Moments_2 expected;
        for (const auto& [ring, sign] : {std::pair(Points{{0, 0}, {4, 0}, {4, 1.5}, {0, 1.5}}, 1.0),
                                         std::pair(Points{{0, 1.5}, {1.5, 1.5}, {1.5, 4}, {0, 4}}, 1.0),
                                         std::pair(l_with_hole[1], -1.0), std::pair(l_with_hole[2], 1.0)}) {
            const Cell_2 cell = Domain_2::polygon(ring).whole({1, 1});
            const Moments_2 m = moments(density, cell.origin, cell.corners);
            expected.mass += sign * m.mass;
            for (std::size_t k = 0; k < 2; ++k) expected.first[k] += sign * m.first[k];
        }
        CHECK(all.mass == Approx(expected.mass).epsilon(1e-9));
        for (std::size_t k = 0; k < 2; ++k) CHECK(all.first[k] == Approx(expected.first[k]).epsilon(1e-9).margin(1e-9));
    }
}
