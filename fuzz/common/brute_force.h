// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tests by the definition whether cells are a Delaunay triangulation of a few points: every cell is compared with every
// point and every other cell. Coordinates are integers below 2^12 in magnitude, so that everything fits 128 bits.
// Nothing here calls the library, and no shortcut is taken: no walk along the hull, no theorem that would allow fewer
// tests.

#include <annulus/types.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace annulus::oracle {

__extension__ using Wide = __int128;

template <int d>
using Grid_point = std::array<int, static_cast<std::size_t>(d)>;
template <int d>
using Cell_of = std::array<Index, static_cast<std::size_t>(d + 1)>;

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

/// The result of brute force for cells: d + 1 indices each, positively oriented; for points that span k < d dimensions
/// k + 1 indices, then `none`, and triangles in 3D consistently oriented.
struct Brute_verdict {
    std::string fault;             ///< empty: a Delaunay triangulation
    std::uint64_t degenerate = 0;  ///< then: pairs of neighbours on one sphere
};

/// Points that span k dimensions, unchanged or projected along an axis that keeps them distinct.
template <int d>
class Brute_force {
  public:
    explicit Brute_force(const std::vector<Grid_point<d>>& points) {
        for (const Grid_point<d>& p : points) {
            brute::Row<d> row;
            Wide square = 0;
            for (std::size_t c = 0; c < d; ++c) row[c] = p[c], square += row[c] * row[c];
            all_.point.push_back(row);
            all_.lift.push_back(square);
        }
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) distinct_ = distinct_ && points[i] != points[j];
        const Index n = all_.size();
        span_ = std::min<int>(n, 2) - 1;
        for (Index b = 1; b < n; ++b)
            for (Index c = 1; c < n; ++c) {
                if constexpr (d == 2) {
                    if (all_.volume({0, b, c}) != 0) span_ = 2;
                } else {
                    const auto normal = brute::cross(all_.from(0, b), all_.from(0, c));
                    if (brute::dot(normal, normal) == 0) continue;
                    if (span_ < 2) span_ = 2, normal_ = normal;
                    for (Index e = 1; e < n; ++e)
                        if (all_.volume({0, b, c, e}) != 0) span_ = 3;
                }
            }
        if (span_ == 2) {
            // Seen along the first axis that is not in their plane.
            std::size_t axis = 2;
            if constexpr (d == 3)
                for (axis = 0; normal_[axis] == 0;) ++axis;
            for (const auto& row : all_.point) plane_.point.push_back({row[(axis + 1) % 3], row[(axis + 2) % 3]});
            plane_.lift = all_.lift;
        }
    }

    [[nodiscard]] int span() const { return span_; }
    [[nodiscard]] bool distinct() const { return distinct_; }

    [[nodiscard]] Brute_verdict verdict(const std::vector<Cell_of<d>>& cells) const {
        Brute_verdict out;
        if (!distinct_) {
            out.fault = "two points are one";
            return out;
        }
        const auto used = static_cast<std::size_t>(span_ + 1);
        for (const Cell_of<d>& c : cells)
            for (std::size_t i = 0; i <= d; ++i)
                if ((c[i] == none) != (i >= used)) {
                    out.fault = "a cell of another dimension";
                    return out;
                }
        if (span_ == 3) {
            if constexpr (d == 3) out.fault = brute::fault_of_cells<3>(all_, cells, out.degenerate);
        } else if (span_ == 2) {
            out.fault = fault_in_plane(cells, out.degenerate);
        } else {
            out.fault = fault_on_line(cells);
        }
        return out;
    }

    /// The lower hull of the lifted points, each raised by a little: a Delaunay triangulation where no two relevant
    /// hyperplanes agree in all heights; otherwise other heights are to be tried. Heights are below 2^32.
    [[nodiscard]] std::vector<Cell_of<d>> triangulated(const std::vector<std::uint64_t>& height) const {
        std::vector<Cell_of<d>> out;
        if (span_ == 3) {
            if constexpr (d == 3)
                for (const auto& c : lower_hull<3>(all_, height)) out.push_back(c);
        } else if (span_ == 2) {
            for (const auto& c : lower_hull<2>(plane_, height)) {
                Cell_of<d> padded;
                padded.fill(none);
                std::copy(c.begin(), c.end(), padded.begin());
                out.push_back(padded);
            }
        } else {
            for (const auto& [a, b] : neighbours_on_line()) {
                Cell_of<d> padded;
                padded.fill(none);
                padded[0] = a, padded[1] = b;
                out.push_back(padded);
            }
        }
        return out;
    }

  private:
    std::string fault_in_plane(const std::vector<Cell_of<d>>& cells, std::uint64_t& degenerate) const {
        std::string fault;
        for (const bool turned : {false, true}) {
            if (d == 2 && turned) break;  // in 2D there is no other side
            std::vector<std::array<Index, 3>> triangles;
            for (const Cell_of<d>& c : cells) triangles.push_back({c[turned ? 1 : 0], c[turned ? 0 : 1], c[2]});
            degenerate = 0;
            fault = brute::fault_of_cells<2>(plane_, triangles, degenerate);
            if (fault.empty()) break;
        }
        return fault;
    }
    [[nodiscard]] std::vector<std::array<Index, 2>> neighbours_on_line() const {
        std::vector<std::array<Index, 2>> out;
        for (Index a = 0; a < all_.size(); ++a)
            for (Index b = 0; b < a; ++b) {
                bool between = false;  // whether a point is between them
                for (Index v = 0; v < all_.size(); ++v)
                    between = between || brute::dot(all_.from(v, a), all_.from(v, b)) < 0;
                if (!between) out.push_back({b, a});
            }
        return out;
    }
    std::string fault_on_line(const std::vector<Cell_of<d>>& cells) const {
        auto expected = neighbours_on_line();
        std::vector<std::array<Index, 2>> found;
        for (const Cell_of<d>& c : cells) found.push_back({std::min(c[0], c[1]), std::max(c[0], c[1])});
        std::sort(expected.begin(), expected.end());
        std::sort(found.begin(), found.end());
        return expected == found ? "" : "the edges do not join neighbours on the line";
    }
    template <std::size_t k>
    static std::vector<std::array<Index, k + 1>> lower_hull(brute::Lifted<k> x,
                                                            const std::vector<std::uint64_t>& height) {
        for (std::size_t i = 0; i < x.lift.size(); ++i) x.lift[i] = (x.lift[i] << 40) + static_cast<Wide>(height[i]);
        std::vector<std::array<Index, k + 1>> out;
        std::array<Index, k + 1> c;
        for (std::size_t i = 0; i <= k; ++i) c[i] = static_cast<Index>(i);
        for (;;) {
            auto positive = c;
            if (x.volume(c) < 0) std::swap(positive[0], positive[1]);
            bool lower = x.volume(c) != 0;
            for (Index v = 0; v < x.size() && lower; ++v)
                lower = std::find(c.begin(), c.end(), v) != c.end() || x.above(positive, v) > 0;
            if (lower) out.push_back(positive);
            std::size_t i = k + 1;  // the next subset
            while (i > 0 && c[i - 1] == x.size() - static_cast<Index>(k + 2 - i)) --i;
            if (i == 0) return out;
            ++c[i - 1];
            for (; i <= k; ++i) c[i] = c[i - 1] + 1;
        }
    }

    brute::Lifted<static_cast<std::size_t>(d)> all_;
    brute::Lifted<2> plane_;  ///< where the points span a plane
    brute::Row<3> normal_{};
    bool distinct_ = true;
    int span_ = -1;  ///< -1 and 0 for no point and one
};

}  // namespace annulus::oracle
