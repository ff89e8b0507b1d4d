// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cells and points of R^k compared by the definition: positive cells, empty spheres, no overlap, the hull filled. For
// Brute_force (brute_force.h), with the same rules: nothing here calls the library.

#include <annulus/types.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace annulus::oracle {

__extension__ using Wide = __int128;

namespace brute {

template <std::size_t d>
using Row = std::array<Wide, d>;

inline Wide determinant(const std::array<Row<2>, 2>& m) { return m[0][0] * m[1][1] - m[0][1] * m[1][0]; }
inline Row<3> cross(const Row<3>& u, const Row<3>& v) {
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
template <std::size_t d>
Wide dot(const Row<d>& u, const Row<d>& v) {
    Wide sum = 0;
    for (std::size_t k = 0; k < d; ++k) sum += u[k] * v[k];
    return sum;
}
inline Wide determinant(const std::array<Row<3>, 3>& m) { return dot(cross(m[0], m[1]), m[2]); }
inline int sign(Wide x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
inline std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Points of R^k with a number each on top: their squared length, as a rule.
template <std::size_t k>
struct Lifted {
    std::vector<Row<k>> point;
    std::vector<Wide> lift;

    [[nodiscard]] Index size() const { return static_cast<Index>(point.size()); }
    [[nodiscard]] Row<k> from(Index a, Index b) const {
        Row<k> v;
        for (std::size_t c = 0; c < k; ++c) v[c] = point[at(b)][c] - point[at(a)][c];
        return v;
    }
    /// k! times the volume.
    [[nodiscard]] Wide volume(const std::array<Index, k + 1>& c) const {
        std::array<Row<k>, k> rows;
        for (std::size_t i = 0; i < k; ++i) rows[i] = from(c[0], c[i + 1]);
        return determinant(rows);
    }
    /// Positive when v is above the hyperplane of the lifted points of c, which is positive: for squared lengths,
    /// outside its sphere.
    [[nodiscard]] int above(const std::array<Index, k + 1>& c, Index v) const {
        Wide sum = (lift[at(v)] - lift[at(c[0])]) * volume(c);
        for (std::size_t i = 1; i <= k; ++i) {
            // The weight of corner i in v, times the volume of c.
            std::array<Index, k + 1> replaced = c;
            replaced[i] = v;
            sum -= (lift[at(c[i])] - lift[at(c[0])]) * volume(replaced);
        }
        return sign(sum);
    }
    /// Corner i of c left out.
    [[nodiscard]] static std::array<Index, k> facet(const std::array<Index, k + 1>& c, std::size_t i) {
        std::array<Index, k> f;
        for (std::size_t j = 0, r = 0; j <= k; ++j)
            if (j != i) f[r++] = c[j];
        return f;
    }
    /// The side of the facet f of a cell on which v is.
    [[nodiscard]] int side(const std::array<Index, k>& f, Index v) const {
        std::array<Index, k + 1> c;
        std::copy(f.begin(), f.end(), c.begin());
        c[k] = v;
        return sign(volume(c));
    }
};

/// All directions that can separate two simplices of R^k that do not overlap.
inline std::vector<Row<2>> axes(const std::vector<Row<2>>& edges, const std::vector<Row<2>>& other_edges) {
    std::vector<Row<2>> n;
    for (const auto* all : {&edges, &other_edges})
        for (const Row<2>& e : *all) n.push_back({-e[1], e[0]});
    return n;
}
inline std::vector<Row<3>> axes(const std::vector<Row<3>>& edges, const std::vector<Row<3>>& other_edges) {
    std::vector<Row<3>> n;
    std::vector<Row<3>> all = edges;
    all.insert(all.end(), other_edges.begin(), other_edges.end());
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) n.push_back(cross(all[i], all[j]));
    return n;
}

template <std::size_t k>
[[nodiscard]] bool overlap(const Lifted<k>& x, const std::array<Index, k + 1>& c, const std::array<Index, k + 1>& e) {
    const auto edges = [&x](const std::array<Index, k + 1>& cell) {
        std::vector<Row<k>> out;
        for (std::size_t i = 0; i <= k; ++i)
            for (std::size_t j = 0; j < i; ++j) out.push_back(x.from(cell[j], cell[i]));
        return out;
    };
    for (const Row<k>& n : axes(edges(c), edges(e))) {
        if (dot(n, n) == 0) continue;
        const auto range = [&](const std::array<Index, k + 1>& cell) {
            Wide low = dot(n, x.point[at(cell[0])]), high = low;
            for (const Index v : cell) {
                const Wide h = dot(n, x.point[at(v)]);
                low = std::min(low, h), high = std::max(high, h);
            }
            return std::pair(low, high);
        };
        const auto [a, b] = range(c);
        const auto [f, g] = range(e);
        if (b <= f || g <= a) return false;
    }
    return true;
}

/// k! times the volume of the hull: over the facets of the hull, each of them once.
inline Wide hull_volume(const Lifted<2>& x) {
    Wide sum = 0;
    for (Index a = 0; a < x.size(); ++a)
        for (Index b = 0; b < x.size(); ++b) {
            bool whole = a != b;  // an edge of the hull from corner to corner, all points on its left
            for (Index v = 0; v < x.size() && whole; ++v) {
                const int s = x.side({a, b}, v);
                const Row<2> to_a = x.from(v, a), to_b = x.from(v, b);
                whole = s > 0 || (s == 0 && dot(to_a, to_b) <= 0);
            }
            if (whole) sum += x.volume({0, a, b});
        }
    return sum;
}
inline Wide hull_volume(const Lifted<3>& x) {
    Wide sum = 0;
    std::vector<std::uint64_t> seen;  // which points are on a plane of the hull
    for (Index a = 0; a < x.size(); ++a)
        for (Index b = 0; b < x.size(); ++b)
            for (Index c = 0; c < x.size(); ++c) {
                const Row<3> n = cross(x.from(a, b), x.from(a, c));
                if (dot(n, n) == 0) continue;
                std::uint64_t on = 0;
                bool outer = true;
                for (Index v = 0; v < x.size() && outer; ++v) {
                    const Wide h = dot(n, x.from(a, v));
                    outer = h <= 0;
                    if (h == 0) on |= std::uint64_t{1} << v;
                }
                if (!outer || std::find(seen.begin(), seen.end(), on) != seen.end()) continue;
                seen.push_back(on);
                // Its corners in order, as in 2D, seen along n.
                const auto is_on = [on](Index v) { return (on >> v & 1U) != 0; };
                for (Index u = 0; u < x.size(); ++u)
                    for (Index w = 0; w < x.size(); ++w) {
                        bool whole = u != w && is_on(u) && is_on(w);
                        for (Index v = 0; v < x.size() && whole; ++v) {
                            if (!is_on(v)) continue;
                            const int s = sign(dot(n, cross(x.from(u, w), x.from(u, v))));
                            whole = s > 0 || (s == 0 && dot(x.from(v, u), x.from(v, w)) <= 0);
                        }
                        if (whole) sum += x.volume({0, a, u, w});
                    }
            }
    return sum;
}

/// Empty, or why these are not a Delaunay triangulation of points that span R^k. Counts pairs of cells with the same
/// sphere.
template <std::size_t k>
[[nodiscard]] std::string fault_of_cells(const Lifted<k>& x, const std::vector<std::array<Index, k + 1>>& cells,
                                         std::uint64_t& degenerate) {
    std::vector<char> used(x.point.size(), 0);
    Wide sum = 0;
    for (const auto& c : cells) {
        for (const Index v : c) {
            if (v < 0 || v >= x.size()) return "a cell names no point";
            used[at(v)] = 1;
        }
        if (x.volume(c) <= 0) return "a cell is not positive";
        sum += x.volume(c);
        for (Index v = 0; v < x.size(); ++v)
            if (x.above(c, v) < 0) return "a sphere is not empty";
    }
    if (std::find(used.begin(), used.end(), 0) != used.end()) return "a point is no vertex";
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (overlap(x, cells[i], cells[j])) return "two cells overlap";
    if (sum != hull_volume(x)) return "the cells do not fill the hull";
    for (const auto& c : cells)
        for (std::size_t i = 0; i <= k; ++i) {
            auto f = x.facet(c, i);
            bool hull = true;
            for (Index v = 0; v < x.size() && hull; ++v) hull = x.side(f, v) * x.side(f, c[i]) >= 0;
            std::sort(f.begin(), f.end());
            int others = 0;
            for (const auto& e : cells)
                for (std::size_t j = 0; j <= k; ++j) {
                    auto g = x.facet(e, j);
                    std::sort(g.begin(), g.end());
                    if (&e == &c || g != f) continue;
                    ++others;
                    if (&e < &c && x.above(c, e[j]) == 0) ++degenerate;
                }
            if (others != (hull ? 0 : 1)) return "cells do not meet facet to facet";
        }
    return {};
}

}  // namespace brute

}  // namespace annulus::oracle
