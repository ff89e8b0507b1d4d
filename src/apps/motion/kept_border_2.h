// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/motion/region_2.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Which vertices stay on the border of a polygon: those that are there at the beginning. A vertex at a corner rests,
/// one on an edge moves along it. Immutable.
class Kept_border_2 {
  public:
    /// No vertices.
    Kept_border_2() = default;
    /// The vertices that are no farther from an edge of the domain than 1e5 times its `tolerance()`, which is 1e-9
    /// times its greatest distance from (0, 0); at a corner if they are no farther from it than that. O(n log edges)
    /// expected; in a convex polygon O(n edges). Throws Error(usage) for a disc.
    Kept_border_2(const Region_2& domain, std::span<const Coordinates<2>> position);

    [[nodiscard]] bool has(std::size_t v) const { return v < edge_.size() && edge_[v] != elsewhere; }
    /// The number of these vertices.
    [[nodiscard]] std::size_t count() const { return count_; }
    /// The point of the edge of v that is nearest to p, but not beyond the middle between `from`, where v is, and an
    /// end of the edge; `from` at a corner. Cells of vertices on one edge are separated by lines across it: so if each
    /// p is in the cell of its vertex, these points differ, and so do those of vertices on different edges.
    /// Precondition: has(v).
    [[nodiscard]] Coordinates<2> along(std::size_t v, const Coordinates<2>& from, const Coordinates<2>& p) const;

  private:
    static constexpr std::size_t elsewhere = static_cast<std::size_t>(-1), corner = elsewhere - 1;

    std::vector<std::array<Coordinates<2>, 2>> edges_;
    std::vector<std::size_t> edge_;  ///< by vertex
    std::size_t count_ = 0;
};

}  // namespace annulus::inline v1
