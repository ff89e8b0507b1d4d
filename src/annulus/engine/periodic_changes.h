// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/periodic_state.h>

#include <compare>
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

/// The edges that a change of a periodic triangulation made and broke, ascending.
template <int d>
struct Image_pair_changes {
    std::vector<Image_pair<d>> made;    ///< between the points after it
    std::vector<Image_pair<d>> broken;  ///< between the points before it
};

/// What has changed, where both states have the same points elsewhere, but for those that came or went. Which edges are
/// the same is decided by the image of each point that is nearest to where the affine map of the boxes takes it, so
/// that points that are given as other images, and a box that is given in another basis, change nothing. Where no
/// unimodular matrix relates the boxes, nearly, every edge is broken, and every one made. O(n), and O(k log k) for k
/// cells that have not the number that they had.
template <int d>
[[nodiscard]] Image_pair_changes<d> periodic_changes(const Periodic_state<d>& before, const Periodic_state<d>& after);

extern template Image_pair_changes<2> periodic_changes(const Periodic_state<2>&, const Periodic_state<2>&);
extern template Image_pair_changes<3> periodic_changes(const Periodic_state<3>&, const Periodic_state<3>&);

}  // namespace annulus::inline v1
