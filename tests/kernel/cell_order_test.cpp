// SPDX-License-Identifier: GPL-3.0-or-later
// The order of the cells of a built mesh (kernel/cell_order.h) past its batches: more than 4 (2D) or 8 (3D) cells with
// the same largest rank, fewer and more than 16 cells, fewer and more than 32 ranks, and 32 ranks with fewer and more
// than 512 cells. Seen through Moving_mesh, whose cells() have the order of the mesh.
#include <annulus/moving_mesh.h>

#include <support/catch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

using namespace annulus;

namespace {

template <int d>
using Positions = std::vector<Coordinates<d>>;

/// Points on two lines, `n` on each. A sphere meets a line twice at most: each cell has an edge of either line, every
/// such pair is a cell, and each vertex is in n - 1 or 2 n - 2 cells.
Positions<3> two_lines(std::size_t n) {
    Positions<3> x;
    for (std::size_t i = 0; i < n; ++i) {
        const double t = static_cast<double>(i) - static_cast<double>(n) / 2.0 + 0.25;
        x.push_back({t, 0, 1});
        x.push_back({0, t, -1});
    }
    return x;
}

/// Eight wheels: all of the `rim` points of each, nearly on a circle, are neighbours of its hub. The hubs are near the
/// rim in eight directions: whichever way a curve through all points goes, it passes most of a rim before some hub.
Positions<2> wheels(std::size_t rim) {
    Positions<2> x;
    for (int k = 0; k < 8; ++k) {
        const double east = 5.0 * (k % 4), north = 5.0 * (k / 4), turn = 0.785398163397 * k + 0.2;
        for (std::size_t i = 0; i < rim; ++i) {
            const double angle = 6.28318530718 * static_cast<double>(i) / static_cast<double>(rim);
            x.push_back({east + std::cos(angle), north + std::sin(angle)});
        }
        x.push_back({east + 0.9 * std::cos(turn), north + 0.9 * std::sin(turn)});
    }
    return x;
}

/// Whether the cells are in the order that cell_order.h promises, and are linked as they should be. Returns how many
/// cells the largest group has, of those whose vertex of the largest rank is the same.
template <int d>
std::size_t check(std::span<const Coordinates<d>> x, int threads) {
    Options options;
    options.strategy = Strategy::rebuild;
    options.threads = threads;
    const Moving_mesh<d> mesh(x, options);
    REQUIRE(mesh.audit().delaunay());
    const Mesh_cells<d> cells = mesh.cells();
    // The vertex of the largest rank is the first one, so that ranks are known of most vertices; 0 where not.
    std::vector<std::size_t> rank(x.size(), 0);
    std::size_t ranks = 0, begin = 0, largest = 0;
    const auto& v = cells.vertices;
    for (std::size_t c = 0; c < v.size(); ++c) {
        if (c == 0 || v[c][0] != v[c - 1][0]) {
            REQUIRE(rank[static_cast<std::size_t>(v[c][0])] == 0);  // one group, in one place
            rank[static_cast<std::size_t>(v[c][0])] = ++ranks;
            begin = c;
        }
        largest = std::max(largest, c - begin + 1);
    }
    const auto rank_of = [&](std::size_t c, std::size_t i) { return rank[static_cast<std::size_t>(v[c][i])]; };
    const auto is_less = [](std::size_t l, std::size_t r) { return l != 0 && r != 0 && l < r; };
    std::size_t misplaced = 0, unlinked = 0;
    for (std::size_t c = 0; c < v.size(); ++c) {
        for (std::size_t i = 1; i <= d; ++i) {
            misplaced += is_less(rank_of(c, 0), rank_of(c, i)) ? 1U : 0U;
            if (d == 3 && i > 1) misplaced += is_less(rank_of(c, i), rank_of(c, 1)) ? 1U : 0U;
        }
        if (c > 0 && v[c][0] == v[c - 1][0]) {
            misplaced += is_less(rank_of(c, 1), rank_of(c - 1, 1)) ? 1U : 0U;
            misplaced += v[c][1] == v[c - 1][1] && is_less(rank_of(c, 2), rank_of(c - 1, 2)) ? 1U : 0U;
        }
        for (std::size_t i = 0; i <= d; ++i) {
            const Index n = cells.neighbours[c][i];
            if (n == Mesh_cells<d>::outside) continue;
            const auto& back = cells.neighbours[static_cast<std::size_t>(n)];
            const auto j =
                static_cast<std::size_t>(std::find(back.begin(), back.end(), static_cast<Index>(c)) - back.begin());
            auto here = v[c], there = v[static_cast<std::size_t>(n)];
            if (j <= d) here[i] = there[j] = none;
            std::sort(here.begin(), here.end());
            std::sort(there.begin(), there.end());
            unlinked += here != there ? 1U : 0U;
        }
    }
    CHECK(misplaced == 0);
    CHECK(unlinked == 0);
    return largest;
}

}  // namespace

TEST_CASE("Cells are in order where 32 vertices have about 512 of them, in 3D", "[kernel]") {
    std::size_t largest = 0;
    for (const std::size_t n : {2U, 3U, 4U, 5U, 8U, 15U, 16U, 17U, 28U, 30U, 31U, 32U, 33U, 34U, 36U, 80U}) {
        CAPTURE(n);
        const Positions<3> x = two_lines(n);
        largest = std::max(largest, check<3>(x, 1));
        (void)check<3>(x, 2);
    }
    CHECK(largest > 64);  // eight batches
}

TEST_CASE("Cells are in order where one vertex has more than 512 of them, in 2D", "[kernel]") {
    std::size_t largest = 0;
    for (const std::size_t rim : {3U, 4U, 5U, 30U, 800U}) {
        CAPTURE(rim);
        const Positions<2> x = wheels(rim);
        largest = std::max(largest, check<2>(x, 1));
        (void)check<2>(x, 2);
    }
    CHECK(largest > 512);
}
