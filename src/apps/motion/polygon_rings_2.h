// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/motion/ring_corners_2.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// The error of rings of which two edges meet elsewhere than at a common corner.
class Edge_error : public Corner_error {
  public:
    Edge_error(std::size_t corner, std::size_t other, const std::string& what)
        : Corner_error(corner, what), other_(other) {}
    /// The corner at which the second of these edges begins; the first begins at `corner()`.
    [[nodiscard]] std::size_t other() const noexcept { return other_; }

  private:
    std::size_t other_;
};

/// The edges of a polygon with holes: the distinct corners of all rings in lexicographic order, and the edges between
/// them, each with its lesser corner first, in lexicographic order. So the same for every list of the same rings.
struct Polygon_edges_2 {
    std::vector<Coordinates<2>> corner;
    std::vector<std::array<std::size_t, 2>> edge;
};

/// Checks the rings of a polygon with holes. Each ring is a list of corners in order, either way round, closed or not
/// (see `ring_corners`). `corners` has those of all rings, one ring after the other, of which `begin` has the indices
/// of the first corners, ascending, the first of them 0. A corner may lie on the line of its neighbours.
///
/// Throws what `ring_corners` does, and Edge_error where edges meet elsewhere than at the common corner of two that
/// follow one another, exactly decided: rings that cross or touch themselves or each other, that go back on themselves
/// or around more than once. Indices, and numbers in messages, are those of the list. O(corners log^2 corners) as long
/// as few bounding boxes of edges overlap.
[[nodiscard]] Polygon_edges_2 polygon_edges(std::span<const Coordinates<2>> corners,
                                            std::span<const std::size_t> begin);

}  // namespace annulus::inline v1
