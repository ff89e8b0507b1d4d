// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/periodic_state.h>

#include <array>
#include <compare>
#include <cstddef>
#include <vector>

namespace annulus::inline v1 {

/// An edge between images of two points: `second`, moved by `shift`, is a neighbour of `first`. Each edge once: first
/// <= second, and of a point and its own image the greater of the two shifts.
template <int d>
struct Image_pair {
    Index first, second;
    Shift<d> shift;  ///< by vectors of the box, between the given points
    friend auto operator<=>(const Image_pair&, const Image_pair&) = default;
};

/// A cell of images of points, positively oriented, written in one way only: its corners ascend by (vertex, offset),
/// the last two exchanged where that makes it positive, and the least offset is 0 in each direction.
template <int d>
struct Image_cell {
    std::array<Index, static_cast<std::size_t>(d + 1)> vertices;
    std::array<Shift<d>, static_cast<std::size_t>(d + 1)> offsets;  ///< by vectors of the box, of the given points
    friend auto operator<=>(const Image_cell&, const Image_cell&) = default;
};

/// The edges and cells that a change of a periodic triangulation made, of the points after it, and those that it broke
/// or took away, of the points before it, ascending.
template <int d>
struct Image_changes {
    std::vector<Image_pair<d>> made, broken;
    std::vector<Image_cell<d>> changed, gone;
};

/// What has changed, where both states have the same points elsewhere, but for those that came or went. Which edges and
/// cells are the same is decided by the image of each point that is nearest to where the affine map of the boxes takes
/// it, so that points that are given as other images, and a box that is given in another basis, change nothing. A cell
/// that was turned over is gone, and another one. Where no unimodular matrix relates the boxes, nearly, all edges and
/// cells are gone, and others are there. O(n), and O(k log k) for k cells that have not the number that they had.
template <int d>
[[nodiscard]] Image_changes<d> periodic_changes(const Periodic_state<d>& before, const Periodic_state<d>& after);

extern template Image_changes<2> periodic_changes(const Periodic_state<2>&, const Periodic_state<2>&);
extern template Image_changes<3> periodic_changes(const Periodic_state<3>&, const Periodic_state<3>&);

}  // namespace annulus::inline v1
