// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/triangle_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace annulus_test {

using annulus::Coordinates;
using annulus::Index;
using annulus::Triangle_surface;

/// Coordinates in [-1, 1).
inline std::vector<Coordinates<3>> random_points(std::size_t n, unsigned seed) {
    std::mt19937_64 bits(seed);
    const auto number = [&] { return static_cast<double>(bits() >> 11) * 0x1p-52 - 1; };
    std::vector<Coordinates<3>> points(n);
    for (auto& p : points) p = {number(), number(), number()};
    return points;
}

/// The box from -s to s.
inline Triangle_surface box(const Coordinates<3>& s) {
    Triangle_surface out;
    for (int i = 0; i < 8; ++i)
        out.points.push_back({i & 1 ? s[0] : -s[0], i & 2 ? s[1] : -s[1], i & 4 ? s[2] : -s[2]});
    out.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return out;
}

/// The regular octahedron with corners at distance 1, its triangles cut into four `times` times, points at distance 1.
inline Triangle_surface round_octahedron(int times) {
    Triangle_surface s;
    s.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    s.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (; times > 0; --times) {
        std::map<std::pair<Index, Index>, Index> middle;
        const auto between = [&](Index a, Index b) {
            const auto [at, is_new] =
                middle.emplace(std::pair(std::min(a, b), std::max(a, b)), static_cast<Index>(s.points.size()));
            if (is_new) {
                const auto &p = s.points[static_cast<std::size_t>(a)], &q = s.points[static_cast<std::size_t>(b)];
                Coordinates<3> m{p[0] + q[0], p[1] + q[1], p[2] + q[2]};
                const double length = std::hypot(m[0], m[1], m[2]);
                for (double& x : m) x /= length;
                s.points.push_back(m);
            }
            return at->second;
        };
        std::vector<std::array<Index, 3>> next;
        for (const auto& t : s.triangles) {
            const Index a = between(t[0], t[1]), b = between(t[1], t[2]), c = between(t[2], t[0]);
            next.insert(next.end(), {{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}});
        }
        s.triangles = next;
    }
    return s;
}

/// A ball with two bulges and two dents: not convex. Crosses itself for a depth above 0.36.
inline Triangle_surface dented(double depth = 0.25) {
    Triangle_surface s = round_octahedron(2);
    for (auto& p : s.points) {
        const double shape = 0.55 + 3 * depth * p[0] * p[1] * (1 - p[2] * p[2]) + 0.05 * p[2];
        for (double& x : p) x *= shape;
    }
    return s;
}

/// The winding number of a surface around a point, by the solid angles of its triangles (van Oosterom and Strackee).
inline double winding(const Triangle_surface& s, const Coordinates<3>& o) {
    double sum = 0;
    for (const auto& t : s.triangles) {
        Coordinates<3> e[3];
        double l[3];
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) e[i][k] = s.points[static_cast<std::size_t>(t[i])][k] - o[k];
            l[i] = std::hypot(e[i][0], e[i][1], e[i][2]);
        }
        const auto dot = [&](std::size_t i, std::size_t j) {
            return e[i][0] * e[j][0] + e[i][1] * e[j][1] + e[i][2] * e[j][2];
        };
        const double det = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                           e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
        sum += 2 * std::atan2(det, l[0] * l[1] * l[2] + dot(0, 1) * l[2] + dot(1, 2) * l[0] + dot(2, 0) * l[1]);
    }
    return sum / (4 * std::numbers::pi);
}

/// Every edge once in each direction.
inline bool closed(const Triangle_surface& s) {
    std::map<std::pair<Index, Index>, int> count;
    for (const auto& t : s.triangles)
        for (std::size_t i = 0; i < 3; ++i) ++count[{t[i], t[(i + 1) % 3]}];
    for (const auto& [edge, n] : count) {
        const auto other = count.find({edge.second, edge.first});
        if (n != 1 || other == count.end() || other->second != 1) return false;
    }
    return !count.empty();
}

}  // namespace annulus_test
