// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/triangle_surface.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace annulus::inline v1 {

/// An edge that is not in exactly two triangles that run through it in opposite directions.
struct Edge_fault {
    enum class Kind { open, crowded, turned };
    Kind kind;
    std::size_t triangle;  ///< of the crowd the third; of two that are turned against each other the later
    std::size_t other;     ///< of these two the earlier
    std::size_t count;     ///< triangles at the edge
};

/// What keeps a surface from being closed; nothing when it is. Crowded and turned edges come first, then the open one
/// whose triangle is first. Precondition: indices name points. O(n log n).
[[nodiscard]] std::optional<Edge_fault> edge_fault(const std::vector<std::array<Index, 3>>& triangles);

/// The first triangle whose corners are on a line; nothing when there is none. Exact. Precondition: indices name
/// points, which are finite.
[[nodiscard]] std::optional<std::size_t> flat_triangle(const Triangle_surface& surface);

/// The first two triangles that meet outside corners and edges that they share; nothing when there are none. Sheets may
/// touch at a corner that they share. Exact. O(n log n), and the pairs of triangles whose boxes meet. Preconditions:
/// indices name points, which are finite; no triangle is flat.
[[nodiscard]] std::optional<std::array<std::size_t, 2>> crossing_triangles(const Triangle_surface& surface);

}  // namespace annulus::inline v1
