// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/polyline_3.h>
#include <apps/motion/triangle_surface.h>

#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The sharp edges of a surface, joined to curves that run from corner to corner or are closed.
///
/// An edge is sharp when the normals of its two triangles differ by more than an angle; convex and concave edges are
/// treated alike. A corner is a vertex at which one sharp edge ends, or more than two meet, or two whose directions
/// differ by more than that angle.
class Feature_curves {
  public:
    /// The place of a vertex: on a curve, given by its number; at a corner; or off both.
    enum class Place : Index { off = -1, corner = -2 };

    /// Precondition: every edge is in two triangles that have area. Throws Error(usage) unless 0 < degrees < 180. O(n
    /// log n).
    Feature_curves(const Triangle_surface& surface, double degrees);

    [[nodiscard]] const std::vector<Polyline_3>& curves() const { return curves_; }
    /// Whether a curve has no corner. A curve with a corner may end where it begins.
    [[nodiscard]] bool goes_around(std::size_t curve) const { return curve >= between_corners_; }
    [[nodiscard]] const std::vector<Coordinates<3>>& corners() const { return corners_; }
    /// For each point the corner or curve within this distance; corners come first, then the curve with the least
    /// number. O(n log n), plus the points in boxes around curves.
    [[nodiscard]] std::vector<Place> places(std::span<const Coordinates<3>> points, double distance) const;
    /// Moves the points that belong to a curve onto it; on an edge parallel to an axis the other coordinates are not
    /// rounded.
    void snap(std::span<Coordinates<3>> points, double distance) const;

  private:
    std::vector<Polyline_3> curves_;  ///< those between corners come first
    std::size_t between_corners_ = 0;
    std::vector<Coordinates<3>> corners_;
};

}  // namespace annulus::inline v1
