// SPDX-License-Identifier: GPL-3.0-or-later
// The order of insertion goes from a vertex to one near it, at every scale, even if a few points make the bounding box
// large.
#include <annulus/kernel/spatial_order.h>

#include <support/catch.h>
#include <support/generators.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <vector>

using namespace annulus;
using annulus::testing::between;
using annulus::testing::Random;
using annulus::testing::unit;

namespace {

template <int d>
using Places = std::vector<Coordinates<d>>;

template <int d>
Coordinates<d> in_box(Random& random) {
    Coordinates<d> p;
    for (double& c : p) c = unit(random);
    return p;
}

template <int d>
std::vector<Index> order_of(const Places<d>& x, Spatial_order<d>& order) {
    std::vector<Index> vertices(x.size());
    std::iota(vertices.begin(), vertices.end(), Index{0});
    order.sort(x, Bounding_box<d>(x, vertices), vertices);
    return vertices;
}

struct Way {
    double length = 0.0;
    std::size_t steps = 0, jumps = 0;
};

/// Distances between consecutive vertices of the last round; skips those of group -1; a jump is from one group to
/// another.
template <int d>
Way way_through(const Places<d>& x, const std::function<int(std::size_t)>& group) {
    Spatial_order<d> order;
    const std::vector<Index> vertices = order_of<d>(x, order);
    Way way;
    const std::uint64_t last_round = order.round(x.size() - 1);
    std::size_t before = x.size();
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        const auto v = static_cast<std::size_t>(vertices[k]);
        if (order.round(k) != last_round || group(v) < 0) continue;
        if (before != x.size() && group(before) != group(v)) {
            ++way.jumps;
        } else if (before != x.size()) {
            double square = 0.0;
            for (std::size_t c = 0; c < d; ++c) square += (x[v][c] - x[before][c]) * (x[v][c] - x[before][c]);
            way.length += std::sqrt(square);
            ++way.steps;
        }
        before = v;
    }
    return way;
}

/// The side of each of n equal boxes in the unit box.
template <int d>
double spacing(std::size_t n) {
    return std::pow(static_cast<double>(n), -1.0 / d);
}

constexpr std::size_t many = 20'000;

}  // namespace

TEMPLATE_TEST_CASE_SIG("Few points far away leave the order of insertion of all others short, dimension",
                       "[spatial_order]", ((int d), d), 2, 3) {
    const std::size_t every = GENERATE(0U, 100U, 10U);  // every so many-th point is far away
    const double reach = GENERATE(1e3, 0x1p40, 0x1p400);
    Random random(5);
    Places<d> x;
    const auto is_far = [every](std::size_t v) { return every != 0 && v % every == 0; };
    while (x.size() < many) {
        x.push_back(in_box<d>(random));
        if (is_far(x.size() - 1))
            for (double& c : x.back()) c = reach * (unit(random) + unit(random) + unit(random) + unit(random) - 2.0);
    }
    const Way way = way_through<d>(x, [&](std::size_t v) { return is_far(v) ? -1 : 0; });
    CAPTURE(every, reach, way.steps, way.length / static_cast<double>(way.steps) / spacing<d>(many));
    REQUIRE(way.steps > many / 2);
    CHECK(way.length < 2.0 * spacing<d>(many) * static_cast<double>(way.steps));
}

TEMPLATE_TEST_CASE_SIG("The order of insertion within clusters is as short as they are small, dimension",
                       "[spatial_order]", ((int d), d), 2, 3) {
    const double width = GENERATE(0x1p-10, 0x1p-30);
    const int clusters = GENERATE(2, 50);
    Random random(6);
    Places<d> centre;
    while (centre.size() < static_cast<std::size_t>(clusters)) centre.push_back(in_box<d>(random));
    const auto cluster = [&](std::size_t v) { return static_cast<int>(v) % clusters; };
    Places<d> x;
    while (x.size() < many) {
        const Coordinates<d>& middle = centre[static_cast<std::size_t>(cluster(x.size()))];
        Coordinates<d> p = in_box<d>(random);
        for (std::size_t c = 0; c < d; ++c) p[c] = middle[c] + width * p[c];
        x.push_back(p);
    }
    const Way way = way_through<d>(x, cluster);
    const double side = width * spacing<d>(many / static_cast<std::size_t>(clusters));
    CAPTURE(width, clusters, way.jumps, way.length / static_cast<double>(way.steps) / side);
    REQUIRE(way.steps > many / 2);
    CHECK(way.jumps < static_cast<std::size_t>(8 * clusters));
    CHECK(way.length < 2.0 * side * static_cast<double>(way.steps));
}

TEMPLATE_TEST_CASE_SIG("The order of insertion is the same at every scale, dimension", "[spatial_order]", ((int d), d),
                       2, 3) {
    Random random(7);
    Places<d> x;
    while (x.size() < many) {
        x.push_back(in_box<d>(random));
        if (x.size() % 10 == 0)
            for (double& c : x.back()) c *= 0x1p-40;
        if (x.size() % 10 == 1)
            for (double& c : x.back()) c *= 0x1p40;
    }
    Spatial_order<d> order;
    const std::vector<Index> expected = order_of<d>(x, order);
    for (const double scale : {0x1p-600, 0x1p-3, 0x1p400}) {
        CAPTURE(scale);
        Places<d> scaled = x;
        for (auto& p : scaled)
            for (double& c : p) c *= scale;
        REQUIRE(order_of<d>(scaled, order) == expected);
    }
}

TEST_CASE("Points at one place keep the order in which they are given", "[spatial_order]") {
    Random random(8);
    Places<3> x;
    while (x.size() < 4'000) x.push_back(x.size() % 2 == 0 ? Coordinates<3>{0.5, 0.25, 0.125} : in_box<3>(random));
    Spatial_order<3> order;
    std::vector<Index> given(x.size());
    std::iota(given.begin(), given.end(), Index{0});
    std::reverse(given.begin(), given.end());
    std::vector<Index> vertices = given;
    order.sort(x, Bounding_box<3>(x, vertices), vertices);
    CHECK(std::is_permutation(vertices.begin(), vertices.end(), given.begin()));
    std::size_t pairs = 0;
    for (std::size_t k = 1; k < vertices.size(); ++k) {
        if (vertices[k - 1] % 2 != 0 || vertices[k] % 2 != 0 || order.round(k - 1) != order.round(k)) continue;
        REQUIRE(vertices[k - 1] > vertices[k]);
        ++pairs;
    }
    CHECK(pairs > 1'900);
    const Places<3> one(1'000, x.front());
    std::vector<Index> rest(given.begin() + 3'000, given.end());
    const std::vector<Index> as_given = rest;
    order.sort(one, Bounding_box<3>(one, rest), rest);
    CHECK(rest == as_given);
}
