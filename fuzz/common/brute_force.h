// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tests by the definition whether cells are a Delaunay triangulation of a few points: every cell is compared with every
// point and every other cell. Coordinates are integers below 2^12 in magnitude, so that everything fits 128 bits.
// Nothing here calls the library, and no shortcut is taken: no walk along the hull, no theorem that would allow fewer
// tests.

#include "brute_cells.h"

#include <annulus/types.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace annulus::oracle {

template <int d>
using Grid_point = std::array<int, static_cast<std::size_t>(d)>;
template <int d>
using Cell_of = std::array<Index, static_cast<std::size_t>(d + 1)>;

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
